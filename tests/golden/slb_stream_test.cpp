// SPDX-License-Identifier: Apache-2.0
// Writing the silhouette-line buffer's commands, and finding one's way through its results.
#include <gtest/gtest.h>

#include <array>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>
#include <stdexcept>

#include "tests/golden/run_stream.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/slb_directed.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::StreamWriter;
using golden::Word;
using golden::slb::CoverSample;
using golden::slb::QueryPoint;
using golden::slb::Vertex;

const HardwareConfig kSlb{.en_slb = true};

TEST(SlbWriter, WritesWhatThePageSays) {
  StreamWriter writer(kSlb);
  writer.slb_clear();
  writer.begin_object(7, 0x12345);
  writer.loop(std::vector<Vertex>{{1, -1, 2}});
  writer.loop({});
  writer.fill();
  writer.end_object();
  writer.begin_object(8);
  writer.fill();
  writer.cover(std::vector<CoverSample>{{3, -2, 4, 5}}, 6);
  writer.end_object();
  writer.query(std::vector<QueryPoint>{{-1, 1, 9}}, 10);
  writer.read_entries(3, 300);
  // p = 8, s = Q = 10: coordinates of 20 bits, pixels of 10, depths of 20.
  EXPECT_EQ(
      writer.words(),
      (std::vector<Word>{0x2000000000000000, 0x2101000007012345, 0x2200000100000000, 0x000002FFFFF00001,
                         0x2200000000000000, 0x2300000000000000, 0x2500000000000000, 0x2100000008000000,
                         0x2300000000000000, 0x2400000100000006, 0x00000500004FF803, 0x2500000000000000,
                         0x260000010000000A, 0x00000900001FFFFF, 0x27000000FF000003, 0x270000002B000103}));
}

TEST(SlbWriter, LongListsBecomeSeveralCommands) {
  StreamWriter writer(kSlb);
  writer.begin_object(1, 0);
  writer.loop(std::vector<Vertex>(2 * 65535 + 1));
  writer.loop(std::vector<Vertex>(65535));
  writer.fill();
  writer.cover(std::vector<CoverSample>(65536), 0);
  writer.end_object();
  writer.query(std::vector<QueryPoint>(65536), 0);
  std::vector<std::array<int, 3>> shapes;
  golden::CommandReader reader(writer.words());
  golden::CommandSequence sequence(kSlb);
  while (const auto command = reader.next()) {
    EXPECT_FALSE(sequence.next(command->header));
    shapes.push_back({command->header.op, command->header.flags, command->header.count});
  }
  EXPECT_EQ(shapes, (std::vector<std::array<int, 3>>{{0x21, 1, 0},
                                                     {0x22, 1, 65535},
                                                     {0x22, 1, 65535},
                                                     {0x22, 0, 1},
                                                     {0x22, 0, 65535},
                                                     {0x23, 0, 0},
                                                     {0x24, 0, 65535},
                                                     {0x24, 0, 1},
                                                     {0x25, 0, 0},
                                                     {0x26, 0, 65535},
                                                     {0x26, 0, 1}}));
}

TEST(SlbWriter, RefusesWhatTheHardwareWouldAndWritesNothing) {
  StreamWriter without{HardwareConfig{}};
  EXPECT_THROW(without.slb_clear(), std::logic_error);
  EXPECT_TRUE(without.words().empty());
  StreamWriter writer(kSlb);
  EXPECT_THROW(writer.fill(), std::logic_error);
  EXPECT_THROW(writer.loop(std::vector<Vertex>(3)), std::logic_error);
  EXPECT_THROW(writer.begin_object(1, 1U << 20), std::out_of_range);
  EXPECT_THROW(writer.read_entries(65535, 2), std::out_of_range);
  const std::int64_t beyond = std::int64_t{1} << 19;
  EXPECT_THROW(writer.query(std::vector<QueryPoint>{{0, 0, 0}, {beyond, 0, 0}}, 0), std::out_of_range);
  EXPECT_THROW(writer.query({}, 1U << 20), std::out_of_range);
  EXPECT_TRUE(writer.words().empty());
  writer.begin_object(1);
  const std::size_t before = writer.words().size();
  EXPECT_THROW(writer.loop(std::vector<Vertex>{{0, 0, 0}, {0, -beyond - 1, 0}}), std::out_of_range);
  EXPECT_THROW(writer.query({{QueryPoint{}}}, 0), std::logic_error);
  EXPECT_THROW(writer.slb_clear(), std::logic_error);
  EXPECT_EQ(writer.words().size(), before);
  writer.end_object();
}

/// Raw words among the results may look like anything; their origin says which word of which entry they are.
TEST(SlbResults, EveryWordHasItsOrigin) {
  std::size_t raw_words = 0;
  for (const HardwareConfig& config : stimulus::covering_array()) {
    if (!config.en_slb) continue;
    const auto words = stimulus::random_stream(config, {.seed = 5, .commands = 60, .max_items = 10});
    const auto results = run(config, words).results;
    golden::ResultReader reader(results);
    std::size_t at = 0;
    while (const auto result = reader.next()) {
      ASSERT_EQ(result->offset, at);
      for (std::size_t i = 0; i <= result->raw.size(); ++i, ++at) {
        if (i > 0 && at % 7 != 0) continue;  // finding a word walks the whole stream
        const auto origin = golden::find_result(words, at, config);
        ASSERT_TRUE(origin) << "result " << at;
        EXPECT_EQ(origin->raw_word, i == 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(i - 1)));
        raw_words += i > 0;
        const auto code = static_cast<std::uint8_t>(golden::result_code(result->word));
        if (golden::result_code(result->word) == golden::ResultCode::Error) {
          ASSERT_EQ(golden::decode_error_result(result->word).command_index, origin->command.index);
        } else {
          ASSERT_EQ(code, origin->command.header.op);
        }
        if (code == golden::slb::kEntryCode) {
          const auto range = golden::slb::decode_entry_range(origin->command.header.arg);
          EXPECT_EQ(golden::slb::decode_entry_header(result->word).index, range.first + origin->result);
        }
      }
    }
    EXPECT_EQ(at, results.size());
    EXPECT_FALSE(golden::find_result(words, results.size(), config)) << "more results promised than given";
  }
  EXPECT_GT(raw_words, 200u);
}

TEST(SlbResults, ACutStreamEndsInTheMiddleOfAnEntry) {
  const std::vector<Word> results{0x2700000500000004, 1, 2};
  golden::ResultReader reader(results);
  const auto entry = reader.next();
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->raw.size(), 2u);
  EXPECT_FALSE(reader.next());
}

/// Two different words never read the same, or a mismatch report would show two equal lines.
TEST(SlbDescribe, EveryBitShows) {
  for (const Word word : {Word{0x2680000000000000}, Word{0x27000000FF000004}, Word{0x26FC00FF0000FFFF}}) {
    for (int bit = 0; bit < 64; ++bit)
      EXPECT_NE(golden::describe_result(word), golden::describe_result(word ^ (Word{1} << bit))) << bit;
  }
  for (const HardwareConfig& config : stimulus::covering_array()) {
    if (!config.en_slb) continue;
    const auto slb = config.slb_config();
    for (int index = 0; index < slb.entry_words(); ++index) {
      const Word word = 0x0123456789ABCDEF;
      for (int bit = 0; bit < 64; ++bit)
        EXPECT_NE(describe_entry_word(word, index, slb),
                  describe_entry_word(word ^ (Word{1} << bit), index, slb));
    }
  }
}

/// The names in a raw word are those of the fields that an entry is packed from.
TEST(SlbDescribe, RawWordsNameTheirFields) {
  const auto slb = kSlb.slb_config();
  golden::slb::Entry entry;
  entry.count = 2;
  entry.overflow = true;
  entry.corner = -1;
  entry.full_depth = 0xABCDE;
  golden::slb::Fragment& first = entry.fragments[0];
  first.depth = 76;
  first.object = 3;
  first.op = golden::slb::FragmentOp::And;
  first.threshold_m1 = 2;
  first.a = {.major = true, .cross = true, .frac = 101, .slope = 5};
  entry.fragments[1].depth = 78;
  entry.fragments[1].object = 4;
  entry.fragments[1].cont = true;
  const std::vector<Word> words = pack(entry, slb);
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += describe_entry_word(words[i], static_cast<int>(i), slb) + "\n";
  for (const char* field : {" count=2 ", " overflow=1 ", " open=0 ", " corner=63 ", " full_depth=703710 ",
                            " f0.object[5:0]=3", " f0.op=1 ", " f0.a.slope=5 ", " f0.a.frac=101 ",
                            " f0.a.inner=0 ", " f0.a.cross=1 ", " f0.a.major=1 ", " f0.threshold=2 ",
                            " f0.cont=0 ", " f1.depth=78 ", " f1.object[7:1]=2 ", " f1.cont=1"}) {
    EXPECT_NE(text.find(field), std::string::npos) << field << " in\n" << text;
  }
}

}  // namespace
}  // namespace gnomon::golden_test
