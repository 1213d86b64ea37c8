// SPDX-License-Identifier: Apache-2.0
// The Verilated gnomon_top within the system: golden's words, its counters, faults on its bus.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>
#include <numeric>

#include "firmware/image.hpp"
#include "sim/registers/registers.hpp"
#include "sim/system/system_engine.hpp"
#include "tests/support/random.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::system::test {
namespace {

using Words = std::vector<Word>;

const golden::HardwareConfig kSmall{.plane_log2 = 5};

SystemOptions quick() {
  SystemOptions options;
  options.rtl.quick_build = true;
  options.rtl.assertions = true;
  return options;
}

Words answers(golden::Engine& engine, const Words& words) {
  Words results;
  engine.submit(words);
  engine.drain([&](std::span<const Word> more) { results.insert(results.end(), more.begin(), more.end()); });
  return results;
}

std::uint64_t sum(const std::map<std::string, std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                         [](std::uint64_t all, const auto& count) { return all + count.second; });
}

/// Streams one after the other: words, counters and plane like golden's. How many words were compared.
std::size_t expect_golden(SystemEngine& engine, std::uint64_t first_seed, int streams) {
  const auto golden = golden::make_golden_engine(engine.config());
  std::size_t compared = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(streams); ++seed) {
    const Words words = stimulus::random_stream(engine.config(), {.seed = seed, .commands = 60});
    const Words expected = answers(*golden, words);
    EXPECT_EQ(answers(engine, words), expected) << seed;
    EXPECT_EQ(engine.counters().events, golden->counters().events) << seed;
    compared += expected.size();
  }
  const golden::Counters before = engine.counters();
  EXPECT_EQ(engine.read_plane(), golden->read_plane());
  EXPECT_EQ(engine.counters().events, before.events) << "no counter shows it";
  return compared;
}

TEST(Top, GivesGoldensWordsAndItsCyclesHaveCauses) {
  const auto engine = make_system_engine(kSmall, quick());
  EXPECT_GT(expect_golden(*engine, 1, 6), 1'000u);
  engine->reset();
  EXPECT_GT(expect_golden(*engine, 20, 1), 100u);
  const auto fresh = make_system_engine(kSmall, quick());
  const Words words = stimulus::random_stream(kSmall, {.seed = 20, .commands = 60});
  answers(*fresh, words);
  // Each cycle since power-up has one cause; the copy is taken a few cycles after the firmware's last word.
  EXPECT_NEAR(static_cast<double>(sum(fresh->counters().cycles)), static_cast<double>(fresh->cycle()), 100);
  EXPECT_GT(fresh->counters().cycles.at("cycles.IDLE.IDLE"), 1'000u) << "the firmware starts";
}

TEST(Top, PlanesInMemoryGiveTheSameWords) {
  SystemOptions cached = quick();
  cached.cache_log2 = 12;
  cached.axi_data_bits = 128;
  const auto engine = make_system_engine(kSmall, cached);
  EXPECT_GT(expect_golden(*engine, 40, 4), 500u);
  EXPECT_GT(engine->cache_counters().at("CACHE_PLANE_HITS"), 1'000u);
  EXPECT_TRUE(make_system_engine(kSmall, quick())->cache_counters().empty());
}

TEST(Top, LatencyCostsCyclesNeverWords) {
  SystemOptions slow = quick();
  slow.system.dram.latency = 300;
  const auto near = make_system_engine(kSmall, quick()), far = make_system_engine(kSmall, slow);
  const Words words = stimulus::random_stream(kSmall, {.seed = 9, .commands = 100});
  const Words expected = answers(*near, words);
  EXPECT_GT(expected.size(), 100u);
  EXPECT_EQ(answers(*far, words), expected);
  EXPECT_GT(far->cycle(), near->cycle());
}

/// A fault in one of about 40 transactions: error answers of either kind, and, once `from` faults have been,
/// one in `one_in` of them no answer at all. Such an answer stays due for ever: each reset after it takes
/// AXI_TIMEOUT cycles, which is what time goes into.
struct Silence {
  std::uint64_t from = 0;
  std::int64_t one_in = 60;
};
class RandomFaults {
 public:
  RandomFaults(std::uint64_t seed, Silence silence) : random_(seed), silence_(silence) {}
  Fault operator()() {
    if (random_.between(1, 40) != 1) return Fault::None;
    const auto kind = random_.between(1, silence_.one_in);
    const bool none = kind == 1 && injected >= silence_.from;
    ++injected;
    if (none) ++silent;
    return none ? Fault::NoAnswer : kind % 2 == 0 ? Fault::SlaveError : Fault::DecodeError;
  }
  std::uint64_t injected = 0, silent = 0;

 private:
  stimulus::Random random_;
  Silence silence_;
};

/// Jobs on one system that is never switched off, each beside the golden model, which starts anew where the
/// firmware has reset the hardware.
class FaultyJobs {
 public:
  explicit FaultyJobs(SystemEngine& engine)
      : system_(engine.system()), golden_(golden::make_golden_engine(engine.config())) {}

  void run(std::uint64_t seed, const FaultInjector& faults, std::uint32_t watchdog) {
    std::vector<Job> jobs(1);
    jobs[0].commands = stimulus::random_stream(golden_->config(), {.seed = seed, .commands = 20});
    jobs[0].retries = 2;
    jobs[0].watchdog = watchdog;
    system_.set_fault_injector(faults);
    const JobReport report = system_.run(jobs).at(0);
    resets += report.attempts - 1;
    if ((report.error & 0x100U) != 0) ++watchdogs;
    if (report.attempts > 1) golden_->reset();
    if (report.outcome != registers::mailbox::kOutcomeIsDone) {
      ++failed;
      ++resets;
      wrong += report.results.size();
      golden_->reset();
      return;
    }
    const Words expected = answers(*golden_, jobs[0].commands);
    ++done;
    compared += expected.size();
    wrong += report.results == expected ? 0U : 1U;
  }
  std::uint64_t done = 0, failed = 0, resets = 0, watchdogs = 0, compared = 0, wrong = 0;

 private:
  System& system_;
  std::unique_ptr<golden::Engine> golden_;
};

void expect_no_fault_in_results(std::uint64_t count, Silence silence) {
  const auto engine = make_system_engine(kSmall, quick());
  RandomFaults faults(3, silence);
  stimulus::Random random(4);
  FaultyJobs jobs(*engine);
  std::uint64_t seed = 100, clean = 0;
  while (faults.injected < count) {
    // One in four is cut off by its watchdog, if it takes that long.
    const auto watchdog =
        random.between(1, 4) == 1 ? static_cast<std::uint32_t>(random.between(200, 1'500)) : 0;
    jobs.run(
        seed++, [&](std::uint64_t, bool) { return faults(); }, watchdog);
    // It is right again at once.
    const std::uint64_t done = jobs.done;
    jobs.run(seed++, {}, 0);
    clean += jobs.done - done;
  }
  EXPECT_EQ(clean, (seed - 100) / 2) << "jobs after faults";
  EXPECT_EQ(jobs.wrong, 0U);
  EXPECT_GT(jobs.done - clean, count / 10);
  EXPECT_GT(jobs.failed, count / 20);
  EXPECT_GT(jobs.resets, count * 7 / 10);
  EXPECT_GT(jobs.watchdogs, count / 100);
  EXPECT_GT(faults.silent, count / 125);
  EXPECT_GT(jobs.compared, count * 10);
  const SystemStatistics statistics = engine->system().statistics();
  EXPECT_GT(statistics.cycles_polling, 1'000U) << "resets that take their time";
  EXPECT_LT(statistics.cycles_polling, statistics.cpu.cycles - statistics.cpu.cycles_asleep);
  testing::Test::RecordProperty(
      "tally", testing::PrintToString(std::vector{faults.injected, faults.silent, jobs.watchdogs, jobs.resets,
                                                  jobs.done, jobs.failed, jobs.compared, jobs.wrong}));
}

TEST(Top, AThousandFaultsOnTheBusNeverShowAsResults) {
  expect_no_fault_in_results(1'000, {.from = 850, .one_in = 10});
}

/// By itself, with the label soak: two minutes.
TEST(Soak, FaultsOnTheBusWithSilenceThroughoutNeverShowAsResults) {
  expect_no_fault_in_results(5'000, {});
}

TEST(Top, EndsEarlyAtACycle) {
  SystemOptions options = quick();
  options.rtl.max_cycles = 9'000;
  const auto engine = make_system_engine(kSmall, options);
  engine->submit(stimulus::random_stream(kSmall, {.seed = 14, .commands = 2'000}));
  EXPECT_THROW(engine->drain([](auto) {}), CycleLimit);
  std::size_t found = 0;
  engine->poll([&](auto words, auto cycles) {
    found = words.size();
    EXPECT_TRUE(std::is_sorted(cycles.begin(), cycles.end()));
    EXPECT_LE(cycles.back(), 9'000u);
  });
  EXPECT_GT(found, 50u) << "results are written while the job runs";
}

}  // namespace
}  // namespace gnomon::sim::system::test
