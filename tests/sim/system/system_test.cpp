// SPDX-License-Identifier: Apache-2.0
// Firmware, processor, bus, DRAM and front end together: golden's words, whatever the timing and the faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "sim/registers/registers.hpp"
#include "sim/rtl_engine.hpp"
#include "sim/system/system_engine.hpp"
#include "sim/system/system_top.hpp"
#include "tests/support/random.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::system::test {
namespace {

namespace hw = registers::hardware;
namespace mb = registers::mailbox;
using Words = std::vector<golden::Word>;

std::vector<std::uint8_t> firmware() {
  std::ifstream file(GNOMON_FIRMWARE_IMAGE, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
Words stream(std::uint64_t seed, int commands = 40) {
  return stimulus::random_stream({}, {.seed = seed, .commands = commands});
}
Words answers(golden::Engine& engine, const Words& words) {
  Words results;
  engine.submit(words);
  engine.drain(
      [&](std::span<const golden::Word> more) { results.insert(results.end(), more.begin(), more.end()); });
  return results;
}
Words answers(const Words& words) {
  return answers(*golden::make_golden_engine({}), words);
}

struct Bench {
  std::unique_ptr<golden::Engine> engine = golden::make_golden_engine({});
  std::vector<std::uint8_t> image = firmware();
  System system;
  explicit Bench(const SystemConfig& config = {}) : system(config, *engine, image) {}
};

TEST(System, GivesGoldensWords) {
  Bench bench;
  const auto golden = golden::make_golden_engine({});
  std::vector<Job> jobs(20);
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].commands = stream(i);
  const std::vector<JobReport> reports = bench.system.run(jobs);
  ASSERT_EQ(reports.size(), jobs.size());
  std::size_t compared = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(reports[i].outcome, mb::kOutcomeIsDone);
    EXPECT_EQ(reports[i].results, answers(*golden, jobs[i].commands)) << i;
    compared += reports[i].results.size();
  }
  EXPECT_GT(compared, 1'000u);
  EXPECT_THAT(bench.system.log(), testing::StartsWith("gnomon firmware: hardware 1.1"));
}

TEST(System, ConfigurationsChangeCyclesNeverWords) {
  const Words commands = stream(3, 100);
  const Words expected = answers(commands);
  std::vector<std::uint64_t> cycles;
  SystemConfig slow, fine, small;
  slow.dram.latency = 200;
  fine.quantum = 1;
  small.result_ring_log2 = 6;
  for (const SystemConfig& config : {SystemConfig{}, slow, fine, small}) {
    Bench bench(config);
    const std::vector<Job> jobs{{.commands = commands}};
    EXPECT_EQ(bench.system.run(jobs).at(0).results, expected);
    cycles.push_back(bench.system.statistics().cycles);
  }
  EXPECT_GT(cycles[1], cycles[0] * 2) << "memory latency 200 instead of 20";
  EXPECT_GT(cycles[3], cycles[0]) << "the ring fills up";
}

TEST(System, RepeatsItselfCycleByCycle) {
  const std::vector<Job> jobs{{.commands = stream(4)}};
  Bench first;
  first.system.run(jobs);
  const SystemStatistics a = first.system.statistics();
  Bench second;
  second.system.run(jobs);
  const SystemStatistics b = second.system.statistics();
  EXPECT_EQ(a.cycles, b.cycles);
  EXPECT_EQ(a.cpu, b.cpu);
  EXPECT_EQ(a.dram, b.dram);
}

TEST(System, SaysWhereTimeAndBytesGo) {
  Bench bench;
  const std::vector<Job> jobs{{.commands = stream(5, 400)}};
  const JobReport report = bench.system.run(jobs).at(0);
  const SystemStatistics s = bench.system.statistics();
  EXPECT_GE(s.cycles, jobs[0].commands.size());
  EXPECT_GT(s.cpu.cycles_asleep, s.cpu.cycles / 2) << "the processor sleeps while the hardware works";
  EXPECT_EQ(s.cycles_polling, 0u);
  EXPECT_LT(s.cpu.cycles, s.cycles + 1000);
  EXPECT_EQ(s.bus.at(0).target, "dram");
  EXPECT_EQ(s.bus[0].bytes, s.dram.bytes);
  EXPECT_GE(s.dram.bytes, 8 * (jobs[0].commands.size() + report.results.size()));
  EXPECT_EQ(s.dram.row_hits + s.dram.rows_opened + s.dram.row_conflicts, s.dram.reads + s.dram.writes);
  EXPECT_GT(s.dram.row_hits, s.dram.row_conflicts);
  EXPECT_GT(s.register_writes, 10u);
  EXPECT_LT(report.instructions, 2'000u);
}

TEST(System, CutCommandsAndBadDescriptorsEndInErrors) {
  Bench bench;
  Words cut = stream(6);
  cut.push_back(golden::encode(golden::Header{0, 0, 3, 0}));  // a NOP whose items are missing
  const std::vector<Job> jobs{{.commands = cut}, {.commands = stream(7)}};
  const std::vector<JobReport> reports = bench.system.run(jobs);
  EXPECT_EQ(reports[0].outcome, mb::kOutcomeIsFailed);
  EXPECT_EQ(reports[0].error & 0xFFU, hw::kErrorCodeIsCutCommand);
  EXPECT_EQ(reports[1].results, answers(jobs[1].commands));
}

TEST(System, LogsWhatHappens) {
  const std::vector<Job> jobs{{.commands = stream(10)}};
  Bench silent;
  silent.system.run(jobs);
  const SystemStatistics without = silent.system.statistics();
  Bench bench;
  std::vector<nlohmann::json> events;
  bench.system.set_event_log([&](const std::string& line) { events.push_back(nlohmann::json::parse(line)); });
  bench.system.run(jobs);
  const SystemStatistics with = bench.system.statistics();
  EXPECT_EQ(with.cycles, without.cycles) << "looking changes nothing";
  std::map<std::string, std::uint64_t> count;
  std::uint64_t dram_bytes = 0;
  for (const nlohmann::json& event : events) {
    ++count[event.at("event")];
    if (event.at("event") != "transaction") continue;
    EXPECT_LT(event.at("begin"), event.at("end"));
    EXPECT_EQ(event.at("answer"), "okay");
    if (event.at("target") == "dram") dram_bytes += event.at("bytes").get<std::uint64_t>();
  }
  std::uint64_t transactions = 0;
  for (const BusCount& bus : with.bus) transactions += bus.reads + bus.writes;
  EXPECT_EQ(count["transaction"], transactions);
  EXPECT_EQ(dram_bytes, with.dram.bytes);
  EXPECT_EQ(count["descriptor"], 1u);
  EXPECT_GE(count["interrupt"], 4u) << "doorbell and end of job, up and down";
}

/// A fault in about one of `spacing` transactions.
FaultInjector random_faults(stimulus::Random& random, std::uint64_t& injected, std::int64_t spacing) {
  return [&random, &injected, spacing](std::uint64_t, bool) {
    if (random.between(1, spacing) != 1) return Fault::None;
    ++injected;
    return static_cast<Fault>(random.between(1, 3));
  };
}

TEST(System, AThousandFaultsNeverShowAsResults) {
  Bench bench;
  stimulus::Random random(8);
  std::uint64_t injected = 0, done = 0, failed = 0, compared = 0;
  for (std::uint64_t round = 0; injected < 1'000; ++round) {
    // Reset by the firmware after each error; a fresh job first, so that the engine's state is known.
    std::vector<Job> jobs(1);
    jobs[0].commands = stream(round, 20);
    jobs[0].retries = 6;
    bench.engine->reset();
    bench.system.set_fault_injector(random_faults(random, injected, 40));
    const JobReport report = bench.system.run(jobs).at(0);
    if (report.outcome == mb::kOutcomeIsDone) {
      EXPECT_EQ(report.results, answers(jobs[0].commands));
      compared += report.results.size();
      ++done;
    } else {
      EXPECT_EQ(report.outcome, mb::kOutcomeIsFailed);
      EXPECT_EQ(report.attempts, 7u);
      EXPECT_TRUE(report.results.empty());
      ++failed;
    }
  }
  EXPECT_GT(done, 50u);
  EXPECT_GT(failed, 0u);
  EXPECT_GT(compared, 5'000u);
}

TEST(System, AResetInTheMiddleOfAJobLeavesNothingBehind) {
  Bench bench;
  stimulus::Random random(9);
  const Words next = stream(61);
  std::uint64_t ended = 0, compared = 0;
  for (std::uint64_t round = 0; round < 50; ++round) {
    std::vector<Job> jobs(2);
    jobs[0].commands = stream(100 + round, 60);
    jobs[0].watchdog = static_cast<std::uint32_t>(random.between(1'000, 12'000));  // too short for some
    jobs[1].commands = next;
    bench.engine->reset();
    const std::vector<JobReport> reports = bench.system.run(jobs);
    const bool whole = reports[0].outcome == mb::kOutcomeIsDone;
    if (!whole) {
      EXPECT_EQ(reports[0].error, 0x100u);
      EXPECT_TRUE(reports[0].results.empty());
      ++ended;
    }
    const auto golden = golden::make_golden_engine({});
    if (whole) {
      EXPECT_EQ(reports[0].results, answers(*golden, jobs[0].commands));
    }
    EXPECT_EQ(reports[1].results, answers(*golden, next));
    compared += reports[1].results.size();
  }
  EXPECT_GT(ended, 10u);
  EXPECT_LT(ended, 40u);
  EXPECT_GT(compared, 2'000u);
}

TEST(System, AFirmwareThatDoesNothingReachesTheLimit) {
  const auto engine = golden::make_golden_engine({});
  const std::vector<std::uint8_t> loop{0x6F, 0, 0, 0};
  SystemConfig config;
  config.cycle_limit = 100'000;
  System system(config, *engine, loop);
  EXPECT_THROW(system.run(std::vector<Job>{{.commands = stream(9)}}), std::runtime_error);
}

TEST(System, RefusesWhatDoesNotFit) {
  const auto engine = golden::make_golden_engine({});
  const auto make = [&](const SystemConfig& config, std::size_t bytes) {
    const std::vector<std::uint8_t> image(bytes);
    const System system(config, *engine, image);
  };
  SystemConfig small, ring, quantum;
  small.dram_bytes = 1U << 20U;
  ring.result_ring_log2 = 5;
  quantum.quantum = 0;
  for (const SystemConfig& config : {small, ring, quantum})
    EXPECT_THROW(make(config, 16), std::invalid_argument);
  EXPECT_THROW(make({}, 65537), std::invalid_argument);
  Bench bench;
  EXPECT_THROW(bench.system.run(std::vector<Job>(257)), std::length_error);
}

TEST(System, SeveralLiveInOneProcess) {
  const std::vector<Job> jobs{{.commands = stream(11)}};
  const Words expected = answers(jobs[0].commands);
  const auto first = std::make_unique<Bench>();
  const auto second = std::make_unique<Bench>();
  EXPECT_EQ(first->system.run(jobs).at(0).results, expected);
  EXPECT_EQ(second->system.run(jobs).at(0).results, expected);
  EXPECT_EQ(first->system.statistics().cycles, second->system.statistics().cycles);
  std::vector<Words> found(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(found.size());
    for (Words& results : found)
      threads.emplace_back([&] {
        Bench bench;
        results = bench.system.run(jobs).at(0).results;
      });
  }
  EXPECT_THAT(found, testing::Each(expected));
}

TEST(System, KnowsWhenEachResultLayInMemory) {
  Bench bench;
  const std::vector<Job> jobs{{.commands = stream(12, 100)}};
  const JobReport report = bench.system.run(jobs).at(0);
  ASSERT_EQ(report.result_cycles.size(), report.results.size());
  EXPECT_GT(report.result_cycles.front(), 1'000u) << "the firmware starts first";
  EXPECT_TRUE(std::is_sorted(report.result_cycles.begin(), report.result_cycles.end()));
  EXPECT_LE(report.result_cycles.back(), bench.system.statistics().cycles);
}

/// Throws at the first word.
class BrokenEngine final : public golden::Engine {
 public:
  std::string_view name() const override { return "broken"; }
  const golden::HardwareConfig& config() const override { return config_; }
  void submit(std::span<const golden::Word>) override { throw HangError("it hangs"); }
  void drain(const golden::ResultSink&) override {}
  golden::Counters counters() const override { return {}; }
  void reset() override {}
  std::vector<std::uint32_t> read_plane() override { return {}; }

 private:
  golden::HardwareConfig config_;
};

TEST(System, WhatTheEngineThrowsComesOut) {
  BrokenEngine engine;
  const std::vector<std::uint8_t> image = firmware();
  System system({}, engine, image);
  const std::vector<Job> jobs{{.commands = stream(13)}};
  EXPECT_THROW(system.run(jobs), HangError);
}

TEST(SystemEngine, EndsEarlyWithTheResultsSoFar) {
  const Words words = stream(14, 3'000), expected = answers(words);
  SystemConfig config;
  config.result_ring_log2 = 6;
  SystemEngine whole(config, golden::make_golden_engine({}), firmware());
  whole.submit(words);
  whole.drain_timed([&](auto, auto cycles) { config.max_cycles = cycles[cycles.size() / 2]; });
  SystemEngine limited(config, golden::make_golden_engine({}), firmware());
  limited.submit(words);
  EXPECT_THROW(limited.drain([](auto) {}), CycleLimit);
  EXPECT_EQ(limited.cycle(), config.max_cycles);
  Words found;
  limited.poll([&](auto more, auto cycles) {
    EXPECT_EQ(more.size(), cycles.size());
    found.assign(more.begin(), more.end());
  });
  ASSERT_GT(found.size(), 100u);
  ASSERT_LT(found.size(), expected.size());
  EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin()));

  const std::atomic<bool> abort = true;
  config.abort = &abort;
  SystemEngine interrupted(config, golden::make_golden_engine({}), firmware());
  interrupted.submit(words);
  EXPECT_THROW(interrupted.drain([](auto) {}), Aborted);
}

TEST(SystemEngine, IsAnEngineLikeAnyOther) {
  const auto golden = golden::make_golden_engine({});
  SystemEngine engine({}, golden::make_golden_engine({}), firmware());
  EXPECT_EQ(engine.name(), "system");
  for (std::uint64_t seed = 20; seed < 25; ++seed) {
    const Words words = stream(seed);
    EXPECT_EQ(answers(engine, words), answers(*golden, words));
  }
  EXPECT_EQ(engine.counters().events, golden->counters().events);
  EXPECT_EQ(engine.read_plane(), golden->read_plane());
  EXPECT_EQ(answers(engine, {}), Words{});
  engine.reset();
  EXPECT_EQ(answers(engine, stream(30)), answers(stream(30)));
}

TEST(SystemEngine, HandsOnEveryUnitsResults) {
  golden::HardwareConfig config;
  config.en_slb = true;
  config.en_vpu_topology = true;
  config.plane_log2 = config.slb_plane_log2 = 5;
  const auto golden = golden::make_golden_engine(config);
  SystemEngine engine({}, golden::make_golden_engine(config), firmware());
  std::size_t compared = 0;
  for (std::uint64_t seed = 50; seed < 54; ++seed) {
    const Words words = stimulus::random_stream(config, {.seed = seed, .commands = 150});
    const Words expected = answers(*golden, words);
    EXPECT_EQ(answers(engine, words), expected);
    compared += expected.size();
  }
  EXPECT_GT(compared, 2'000u);
}

TEST(SystemEngine, RunsTheRtlAtItsOwnPace) {
  auto rtl = make_rtl_engine({}, {});
  const RtlEngine& clock = *rtl;
  SystemEngine engine({}, std::move(rtl), firmware(), [&clock] { return clock.cycle(); });
  const auto golden = golden::make_golden_engine({});
  std::size_t compared = 0;
  for (std::uint64_t seed = 40; seed < 44; ++seed) {
    const Words words = stream(seed, 60), expected = answers(*golden, words);
    EXPECT_EQ(answers(engine, words), expected);
    compared += expected.size();
  }
  EXPECT_GT(compared, 500u);
  EXPECT_GT(engine.system().statistics().cycles, clock.cycle());
}

}  // namespace
}  // namespace gnomon::sim::system::test
