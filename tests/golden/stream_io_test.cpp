// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gnomon/golden/stream_io.hpp>
#include <iterator>
#include <string>

#include "tests/support/covering.hpp"

namespace gnomon::golden {
namespace {

class StreamIo : public ::testing::Test {
 protected:
  StreamIo() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("gnomon_stream_io_" + std::string(test->name()) + "_" +
               std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               std::to_string(reinterpret_cast<std::uintptr_t>(this)));
    std::filesystem::create_directories(folder_);
    path_ = folder_ / "a.stream";
  }
  ~StreamIo() override { std::filesystem::remove_all(folder_); }

  std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
  /// What load says after the path, or "loaded".
  std::string failure() const {
    const auto result = load_stream(path_);
    if (!std::holds_alternative<std::string>(result)) return "loaded";
    const std::string& text = std::get<std::string>(result);
    EXPECT_EQ(text.rfind(path_.string() + ": ", 0), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    return text.substr(path_.string().size() + 2);
  }

  std::filesystem::path folder_, path_;
};

TEST_F(StreamIo, RoundTripsEveryBuild) {
  for (const HardwareConfig& config : stimulus::covering_array()) {
    const std::vector<Word> words{0, ~Word{0}, 0x0123456789ABCDEF};
    ASSERT_EQ(save_stream(path_, config, words), std::nullopt);
    const auto result = load_stream(path_);
    ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
    EXPECT_EQ(std::get<StreamFile>(result).config, config);
    EXPECT_EQ(std::get<StreamFile>(result).words, words);
  }
}

TEST_F(StreamIo, LongAndEmptyStreams) {
  for (const std::size_t count : {0u, 200000u}) {
    std::vector<Word> words(count);
    for (std::size_t i = 0; i < count; ++i) words[i] = i * 0x9E3779B97F4A7C15;
    ASSERT_EQ(save_stream(path_, {}, words), std::nullopt);
    const auto result = load_stream(path_);
    ASSERT_TRUE(std::holds_alternative<StreamFile>(result));
    EXPECT_EQ(std::get<StreamFile>(result).words, words);
  }
}

TEST_F(StreamIo, BytesAreAsDescribed) {
  ASSERT_EQ(save_stream(path_, {}, std::vector<Word>{0x1122334455667788}), std::nullopt);
  const auto le32 = [](char value) { return std::string{value, 0, 0, 0}; };
  EXPECT_EQ(bytes(), "GNOMON\x1A\n" + le32(5) + le32(8) + le32(2) + le32(9) + le32(22) + le32(20) + le32(9) +
                         le32(1) + le32(0) + le32(8) + le32(7) + le32(7) + le32(2) + le32(10) + le32(10) +
                         le32(0) + le32(0) + le32(4) + le32(4) + le32(20) + le32(18) + le32(0) + le32(0) +
                         le32(0) + le32(1) + le32(0) + "\x88\x77\x66\x55\x44\x33\x22\x11");
}

/// Files of hardware without the silhouette-line buffer, from before there was one.
TEST_F(StreamIo, Version1IsRead) {
  const auto le32 = [](char value) { return std::string{value, 0, 0, 0}; };
  const std::string head =
      "GNOMON\x1A\n" + le32(1) + le32(7) + le32(3) + le32(9) + le32(22) + le32(20) + le32(9) + le32(0);
  for (const char count : {char{0}, char{1}, char{3}}) {
    std::string file = head + le32(count) + le32(0);
    for (char i = 0; i < count; ++i) file += std::string{1, 2, 3, 4, 5, 6, 7, i};
    write(file);
    const auto result = load_stream(path_);
    ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
    const auto& [config, words] = std::get<StreamFile>(result);
    EXPECT_EQ(config, (HardwareConfig{.voxel_bits = 7, .voxel_frac_bits = 3, .en_vpu_offset = false}));
    ASSERT_EQ(words.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(words[i], Word{i} << 56 | 0x07060504030201);
  }
  write(head.substr(0, 20));
  EXPECT_EQ(failure(), "ends after 20 bytes; the header alone has 48");
}

TEST_F(StreamIo, EverySlbParameterIsKept) {
  HardwareConfig config;
  config.en_slb = true;
  config.slb_plane_log2 = 7;
  config.frac_bits = 4;
  config.slope_bits = 5;
  config.frags_per_pixel = 3;
  config.subpixel_bits = 9;
  config.query_bits = 8;
  config.slb_rounding = slb::Rounding::Published;
  ASSERT_EQ(save_stream(path_, config, {}), std::nullopt);
  const auto result = load_stream(path_);
  ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
  EXPECT_EQ(std::get<StreamFile>(result).config, config);
}

TEST_F(StreamIo, EveryTopologyParameterIsKept) {
  HardwareConfig config;
  config.en_vpu_topology = true;
  config.sub_bits = 3;
  config.span_log2 = 5;
  config.nodes_log2 = 12;
  config.quads_log2 = 11;
  ASSERT_EQ(save_stream(path_, config, {}), std::nullopt);
  const auto result = load_stream(path_);
  ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
  EXPECT_EQ(std::get<StreamFile>(result).config, config);
  config.quads_log2 = 12;
  EXPECT_NE(std::get<StreamFile>(result).config, config);
}

TEST_F(StreamIo, EveryFrameBufferParameterIsKept) {
  HardwareConfig config;
  config.en_frame_buffer = true;
  config.frame_layers_log2 = 2;
  ASSERT_EQ(save_stream(path_, config, {}), std::nullopt);
  const auto result = load_stream(path_);
  ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
  EXPECT_EQ(std::get<StreamFile>(result).config, config);
  config.frame_layers_log2 = 1;
  EXPECT_NE(std::get<StreamFile>(result).config, config);
}

TEST_F(StreamIo, PerspectiveIsKept) {
  ASSERT_EQ(save_stream(path_, {.en_perspective = true}, {}), std::nullopt);
  const auto result = load_stream(path_);
  ASSERT_TRUE(std::holds_alternative<StreamFile>(result)) << std::get<std::string>(result);
  EXPECT_EQ(std::get<StreamFile>(result).config, (HardwareConfig{.en_perspective = true}));
  EXPECT_NE(std::get<StreamFile>(result).config, HardwareConfig{});
}

TEST_F(StreamIo, EachDamageHasItsMessage) {
  ASSERT_EQ(save_stream(path_, {}, std::vector<Word>{1, 2}), std::nullopt);
  const std::string good = bytes();
  ASSERT_EQ(failure(), "loaded");
  const auto damaged = [&](std::size_t at, char value) {
    std::string bad = good;
    bad[at] = value;
    write(bad);
    return failure();
  };
  EXPECT_EQ(damaged(0, 'X'), "is not a Gnomon stream file");
  EXPECT_EQ(damaged(8, 6), "has version 6; this program reads versions 1 to 5");
  EXPECT_EQ(damaged(8, 0), "has version 0; this program reads versions 1 to 5");
  EXPECT_EQ(damaged(12, 3), "names illegal hardware: VOXEL_BITS=3 is out of range 4..11");
  EXPECT_EQ(damaged(15, '\xFF'), "names illegal hardware: VOXEL_BITS=2147483647 is out of range 4..11");
  EXPECT_EQ(damaged(68, 2), "names illegal hardware: SLB_ROUNDING=2 is out of range 0..1");
  EXPECT_EQ(damaged(104, 3), "promises 3 words, but 16 bytes follow the header");
  write(good.substr(0, good.size() - 1));
  EXPECT_EQ(failure(), "promises 2 words, but 15 bytes follow the header");
  write(good + "x");
  EXPECT_EQ(failure(), "promises 2 words, but 17 bytes follow the header");
  write(good.substr(0, 20));
  EXPECT_EQ(failure(), "ends after 20 bytes; the header alone has 112");
  write("");
  EXPECT_EQ(failure(), "is not a Gnomon stream file");
}

TEST_F(StreamIo, FilesThatCannotBeReadOrWritten) {
  EXPECT_EQ(failure(), "cannot open the stream file: No such file or directory");
  std::filesystem::create_directory(path_);
  EXPECT_EQ(failure(), "is a directory, not a stream file");
  EXPECT_EQ(save_stream(path_, {}, {}), path_.string() + ": cannot create the stream file: Is a directory");
  EXPECT_EQ(save_stream(folder_ / "none" / "a", {}, {}),
            (folder_ / "none" / "a").string() + ": cannot create the stream file: No such file or directory");
  EXPECT_EQ(save_stream(folder_ / "b", {.depth_bits = 7}, {}),
            (folder_ / "b").string() + ": not written: DEPTH_BITS=7 is out of range 8..24");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b"));
}

TEST_F(StreamIo, AFullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(save_stream("/dev/full", {}, std::vector<Word>(100000)),
            "/dev/full: cannot write the stream file: No space left on device");
}

}  // namespace
}  // namespace gnomon::golden
