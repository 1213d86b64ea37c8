// SPDX-License-Identifier: Apache-2.0
// Seeded faults in the RTL (GNOMON_MUTATE_*): the comparison notices each, and failing streams shrink.
#include <gtest/gtest.h>

#include <filesystem>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <set>

#include "sim/content_hash.hpp"
#include "sim/shrink.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

const std::vector<std::string> kMutations{"GNOMON_MUTATE_TIES_REPLACE", "GNOMON_MUTATE_NO_FORWARDING",
                                          "GNOMON_MUTATE_ROUND_DEPTH",  "GNOMON_MUTATE_MARGIN_OR_EQUAL",
                                          "GNOMON_MUTATE_LOSE_STICKY",  "GNOMON_MUTATE_KEEP_GENERATION",
                                          "GNOMON_MUTATE_SKIP_BARRIER", "GNOMON_MUTATE_SKID_OVERRUN"};

golden::HardwareConfig config() {
  golden::HardwareConfig config;
  config.plane_log2 = 6;
  return config;
}

/// Without assertions: it is the words that must show the fault.
RtlOptions mutated(const std::string& mutation) {
  RtlOptions options;
  options.defines = {mutation};
  options.stalls = stall_profile(3, 3);
  return options;
}

/// The first stream on which the mutated hardware differs.
std::optional<stimulus::DirectedStream> find_failure(const std::string& mutation) {
  Cosim cosim(config(), mutated(mutation));
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) streams.push_back(random_case(config(), seed, 300));
  for (stimulus::DirectedStream& stream : streams) {
    if (!cosim.run(stream.words, {.stop_at_first = true}).passed()) return std::move(stream);
  }
  return std::nullopt;
}

class Mutation : public testing::TestWithParam<std::string> {};

TEST_P(Mutation, IsNoticed) {
  const auto failure = find_failure(GetParam());
  ASSERT_TRUE(failure.has_value()) << "no stream shows the fault";
  RecordProperty("noticed_by", failure->name);
}

INSTANTIATE_TEST_SUITE_P(Rtl, Mutation, testing::ValuesIn(kMutations), [](const auto& test) {
  return test.param.substr(std::string("GNOMON_MUTATE_").size());
});

/// Every name with the prefix in a text.
std::set<std::string> mutations_in(std::string_view text) {
  constexpr std::string_view kPrefix = "GNOMON_MUTATE_";
  std::set<std::string> found;
  for (std::size_t at = text.find(kPrefix); at != text.npos; at = text.find(kPrefix, at + 1)) {
    const std::size_t end = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789", at);
    const std::string_view name = text.substr(at, end - at);
    if (name != kPrefix) found.emplace(name);  // the prefix alone stands in comments
  }
  return found;
}

TEST(Mutations, AllThatTheRtlOffersAreTested) {
  std::set<std::string> found;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(Toolchain::from_environment().rtl_dir)) {
    if (file.path().extension() == ".sv") found.merge(mutations_in(read_file(file.path())));
  }
  // tests/rtl/slb notices those of the silhouette-line buffer, part by part.
  std::erase_if(found, [](const std::string& name) { return name.starts_with("GNOMON_MUTATE_SLB_"); });
  EXPECT_EQ(found, std::set<std::string>(kMutations.begin(), kMutations.end()));
}

TEST(Mutations, FailingRandomStreamShrinksToAFewWordsAndIsKept) {
  const RtlOptions options = mutated("GNOMON_MUTATE_ROUND_DEPTH");
  ModelCache cache;
  const StillFails fails = differs([] { return golden::make_golden_engine(config()); },
                                   [&] { return make_rtl_engine(config(), options, cache); });
  const std::vector<Word> stream = random_case(config(), 2, 150).words;
  ASSERT_TRUE(fails(stream));
  const Shrunk shrunk = shrink(stream, fails);
  EXPECT_LE(shrunk.stream.size(), 24u);
  EXPECT_LT(shrunk.stream.size(), stream.size() / 20);

  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "shrunk.gnomon";
  ASSERT_EQ(golden::save_stream(file, config(), shrunk.stream), std::nullopt);
  const auto loaded = golden::load_stream(file);
  ASSERT_TRUE(std::holds_alternative<golden::StreamFile>(loaded));
  EXPECT_TRUE(fails(std::get<golden::StreamFile>(loaded).words));
}

}  // namespace
}  // namespace gnomon::sim::test
