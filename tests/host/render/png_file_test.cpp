// SPDX-License-Identifier: Apache-2.0
// Pictures survive the file, the right way up, or leave nothing behind.
#include "host/render/png_file.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <fstream>

namespace gnomon::render {
namespace {

class PngFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "gnomon-png-XXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static Image gradient(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (const int value : {x * 7, y * 13, x + y}) image.rgb.push_back(static_cast<std::uint8_t>(value));
    return image;
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(PngFile, ReadsBackWhatWasWritten) {
  const Image image = gradient(37, 21);
  ASSERT_TRUE(write_png(image, folder_ / "a.png"));
  const auto back = read_png(folder_ / "a.png");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->width, 37);
  EXPECT_EQ(back->height, 21);
  EXPECT_EQ(back->rgb, image.rgb);
  EXPECT_EQ(files(), 1u);
}

TEST_F(PngFile, TheFirstRowOfTheFileIsTheTopOfThePicture) {
  const Image image = gradient(5, 4);
  ASSERT_TRUE(write_png(image, folder_ / "a.png"));
  png_image raw{};
  raw.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&raw, (folder_ / "a.png").c_str()), 0);
  raw.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rows(PNG_IMAGE_SIZE(raw));
  ASSERT_NE(png_image_finish_read(&raw, nullptr, rows.data(), 0, nullptr), 0);
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(rows[y * 15 + i], image.rgb[(3 - y) * 15 + i]);
}

TEST_F(PngFile, AFailureIsOneLineAndLeavesNothing) {
  const auto missing = write_png(gradient(4, 4), folder_ / "no-such-folder" / "a.png");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("no-such-folder"), std::string::npos);
  EXPECT_EQ(missing.error().message.find('\n'), std::string::npos);
  std::filesystem::create_directories(folder_ / "folder.png" / "full");
  ASSERT_FALSE(write_png(gradient(4, 4), folder_ / "folder.png"));
  EXPECT_EQ(files(), 1u);
  std::ofstream(folder_ / "text.png") << "not a picture";
  EXPECT_FALSE(read_png(folder_ / "text.png"));
  EXPECT_FALSE(read_png(folder_ / "absent.png"));
}

}  // namespace
}  // namespace gnomon::render
