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
#include "tests/support/seeded_faults.hpp"

namespace gnomon::sim::test {
namespace {

golden::HardwareConfig config() {
  golden::HardwareConfig config;
  config.plane_log2 = 6;
  return config;
}

/// Without assertions: it is the words that must show the fault.
RtlOptions mutated(const std::string& fault) {
  RtlOptions options;
  options.defines = {"GNOMON_MUTATE_" + fault};
  options.quick_build = true;
  options.stalls = stall_profile(3, 3);
  return options;
}

/// The first stream on which the mutated hardware differs.
std::optional<stimulus::DirectedStream> find_failure(const std::string& fault) {
  Cosim cosim(config(), mutated(fault));
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) streams.push_back(random_case(config(), seed, 300));
  for (stimulus::DirectedStream& stream : streams) {
    if (!cosim.run(stream.words, {.stop_at_first = true}).passed()) return std::move(stream);
  }
  return std::nullopt;
}

class Mutation : public testing::TestWithParam<std::string_view> {};

TEST_P(Mutation, IsNoticed) {
  const auto failure = find_failure(std::string(GetParam()));
  ASSERT_TRUE(failure.has_value()) << "no stream shows the fault";
  RecordProperty("noticed_by", failure->name);
}

INSTANTIATE_TEST_SUITE_P(Rtl, Mutation, testing::ValuesIn(stimulus::kBuiltInFaults),
                         [](const auto& test) { return std::string(test.param); });

using Names = std::set<std::string>;
using FaultLists = std::span<const std::span<const std::string_view>>;

/// Every word in capitals right after `mark`.
Names names_after(std::string_view mark, std::string_view text) {
  Names found;
  for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) {
    const std::string_view rest = text.substr(at + mark.size());
    const std::string_view name =
        rest.substr(0, rest.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789"));
    if (!name.empty()) found.emplace(name);
  }
  return found;
}

/// What the package can build in: constants, and variables in builds that choose at run time.
Names offered(std::string_view package) {
  return names_after(" bit ", package);
}

Names listed(FaultLists lists) {
  Names names;
  for (const auto& list : lists) names.insert(list.begin(), list.end());
  return names;
}

std::filesystem::path rtl_dir() {
  return Toolchain::from_environment().rtl_dir;
}
std::string package() {
  return read_file(rtl_dir() / "mutations_pkg.sv");
}

TEST(Mutations, AllThatTheRtlOffersAreTested) {
  EXPECT_EQ(offered(package()), listed(stimulus::kFaultLists))
      << "tests/support/seeded_faults.hpp lists the faults and the tests that notice them";
}

TEST(Mutations, AFaultWithoutATestAndAListThatIsMissingAreSeen) {
  const Names all = listed(stimulus::kFaultLists);
  EXPECT_TRUE(all.contains("SLB_DRIFT"));
  EXPECT_NE(offered(package() + "  localparam bit SLB_NEW = 1'b1;"), all);
  EXPECT_NE(offered(package() + "  bit SLB_NEW = 1'b0;"), all);
  for (std::size_t left_out = 0; left_out < stimulus::kFaultLists.size(); ++left_out) {
    std::vector lists(stimulus::kFaultLists.begin(), stimulus::kFaultLists.end());
    lists.erase(lists.begin() + static_cast<std::ptrdiff_t>(left_out));
    EXPECT_NE(listed(lists), all);
  }
}

/// A fault outside the package would escape the comparison above; one that is not used proves nothing.
TEST(Mutations, FaultsStandInThePackageAndAreUsed) {
  Names used;
  for (const auto& file : std::filesystem::recursive_directory_iterator(rtl_dir())) {
    if (file.path().extension() != ".sv" || file.path().filename() == "mutations_pkg.sv") continue;
    const std::string text = read_file(file.path());
    used.merge(names_after("mutations_pkg::", text));
    EXPECT_EQ(names_after("GNOMON_MUTATE_", text), Names{}) << file.path();
  }
  EXPECT_EQ(used, listed(stimulus::kFaultLists));
}

TEST(Mutations, FailingRandomStreamShrinksToAFewWordsAndIsKept) {
  const RtlOptions options = mutated("ROUND_DEPTH");
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
