// SPDX-License-Identifier: Apache-2.0
// Jobs from the host's point of view, on the driver compiled for the host and on the image in the simulated
// processor.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>

#include "sim/registers/registers.hpp"
#include "tests/firmware/machines.hpp"
#include "tests/support/random.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::firmware::test {
namespace {

namespace hw = sim::registers::hardware;
namespace mb = sim::registers::mailbox;
using Words = std::vector<golden::Word>;

Words stream(std::uint64_t seed, int commands = 40) {
  return stimulus::random_stream({}, {.seed = seed, .commands = commands});
}

gnomon_job job_of(MockSystem& system, const Words& words) {
  gnomon_job job{};
  job.address = system.place(words);
  job.words = static_cast<std::uint32_t>(words.size());
  return job;
}

/// What the engine answers; it goes on from its state.
Words answers(golden::Engine& engine, const Words& words) {
  Words results;
  engine.submit(words);
  engine.drain(
      [&](std::span<const golden::Word> more) { results.insert(results.end(), more.begin(), more.end()); });
  return results;
}
/// As after power-up.
Words answers(const Words& words) {
  return answers(*golden::make_golden_engine({}), words);
}

template <class Machine>
struct Jobs : testing::Test {
  Machine machine;
  MockSystem& system = machine.system;

  Words results(const gnomon_job& job) { return system.results(job.results_begin, job.results_end); }
  ~Jobs() override {
    EXPECT_EQ(system.hardware.registers.untimely_writes(), 0u) << "writes to frozen registers";
  }
};
using Machines = testing::Types<HostMachine, ImageMachine>;
TYPED_TEST_SUITE(Jobs, Machines);

TYPED_TEST(Jobs, GiveGoldensWords) {
  const auto engine = golden::make_golden_engine({});
  std::size_t words = 0;
  this->machine.start();
  for (std::uint32_t i = 0; i < 20; ++i) {  // more than the table and the ring have places
    const Words commands = stream(i);
    this->system.post(job_of(this->system, commands));
    ASSERT_TRUE(run_jobs(this->machine, i + 1));
    const gnomon_job job = this->system.job(i);
    EXPECT_EQ(job.outcome, mb::kOutcomeIsDone);
    EXPECT_EQ(job.attempts, 1u);
    EXPECT_EQ(job.error, 0u);
    const Words expected_words = answers(*engine, commands);
    EXPECT_EQ(this->results(job), expected_words);
    EXPECT_EQ(job.errors, std::count_if(expected_words.begin(), expected_words.end(), [](golden::Word word) {
                return golden::result_code(word) == golden::ResultCode::Error;
              }));
    words += expected_words.size();
  }
  EXPECT_GT(words, 1'000u);
  EXPECT_EQ(this->system.mailbox.get(mb::kStateOffset), mb::kStateIsReady);
}

TYPED_TEST(Jobs, MayBePostedBeforeTheStartAndManyAtOnce) {
  const auto engine = golden::make_golden_engine({});
  std::vector<Words> expected;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const Words commands = stream(100 + i);
    this->system.post(job_of(this->system, commands));
    expected.push_back(answers(*engine, commands));
  }
  this->machine.start();
  ASSERT_TRUE(run_jobs(this->machine, 8));
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(this->results(this->system.job(i)), expected[i]);
}

TYPED_TEST(Jobs, ManyResultsPassThroughASmallRing) {
  this->system.result_log2 = 6;
  this->system.set_up();
  this->machine.start();
  const Words commands = stream(7, 200);
  this->system.post(job_of(this->system, commands));
  ASSERT_TRUE(run_jobs(this->machine, 1));
  const Words expected = answers(commands);
  EXPECT_GT(expected.size(), 10u * 64u);
  EXPECT_EQ(this->results(this->system.job(0)), expected);
}

TYPED_TEST(Jobs, TheHostMayBeSlowWithoutTheWatchdogBarking) {
  this->system.result_log2 = 6;
  this->system.set_up();
  this->machine.start();
  gnomon_job job = job_of(this->system, stream(7, 200));
  job.watchdog = 20'000;
  this->system.post(job);
  for (int i = 0; i < 400 && this->system.finished() == 0; ++i) {
    for (int wait = 0; wait < 100; ++wait) this->machine.step();  // 10,000 cycles
    this->system.take_results();
  }
  EXPECT_EQ(this->system.job(0).outcome, mb::kOutcomeIsDone);
  EXPECT_EQ(this->system.job(0).attempts, 1u);
}

TYPED_TEST(Jobs, AreRepeatedAfterAnError) {
  this->machine.start();
  const Words commands = stream(8);
  gnomon_job job = job_of(this->system, commands);
  job.retries = 3;
  this->system.hardware.plan = {Misbehaviour{.error = hw::kErrorCodeIsReadSlverr},
                                Misbehaviour{.error = hw::kErrorCodeIsTimeout}};
  this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 1));
  job = this->system.job(0);
  EXPECT_EQ(job.outcome, mb::kOutcomeIsDone);
  EXPECT_EQ(job.attempts, 3u);
  EXPECT_EQ(job.error, hw::kErrorCodeIsTimeout) << "of the last attempt that failed; job 0";
  EXPECT_EQ(this->system.hardware.resets, 2u);
  EXPECT_GT(job.results_begin, 0u) << "after what the failed attempts left";
  EXPECT_EQ(this->results(job), answers(commands));
}

TYPED_TEST(Jobs, FailWhenEveryAttemptDoesAndTheNextGoesOn) {
  this->machine.start();
  const Words commands = stream(9);
  gnomon_job job = job_of(this->system, commands);
  job.retries = 1;
  this->system.hardware.plan = {Misbehaviour{.error = hw::kErrorCodeIsWriteDecerr},
                                Misbehaviour{.error = hw::kErrorCodeIsReadDecerr}};
  this->system.post(job);
  this->system.post(job_of(this->system, commands));
  ASSERT_TRUE(run_jobs(this->machine, 2));
  job = this->system.job(0);
  EXPECT_EQ(job.outcome, mb::kOutcomeIsFailed);
  EXPECT_EQ(job.attempts, 2u);
  EXPECT_EQ(job.error, hw::kErrorCodeIsReadDecerr);
  EXPECT_EQ(job.results_begin, job.results_end);
  EXPECT_EQ(this->results(this->system.job(1)), answers(commands));
}

TYPED_TEST(Jobs, OutsideOfMemoryEndInTheBusError) {
  this->machine.start();
  gnomon_job job{};
  job.address = 0x40000000;
  job.words = 16;
  this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 1));
  EXPECT_EQ(this->system.job(0).outcome, mb::kOutcomeIsFailed);
  EXPECT_EQ(this->system.job(0).error, hw::kErrorCodeIsReadDecerr);
}

TYPED_TEST(Jobs, TheWatchdogEndsWhatDoesNotEnd) {
  this->machine.start();
  const Words commands = stream(10);
  gnomon_job job = job_of(this->system, commands);
  job.retries = 1;
  job.watchdog = 5'000;
  this->system.hardware.plan = {Misbehaviour{.never_ends = true}};
  const std::uint64_t begin = this->system.time;
  this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 1));
  job = this->system.job(0);
  EXPECT_EQ(job.outcome, mb::kOutcomeIsDone);
  EXPECT_EQ(job.attempts, 2u);
  EXPECT_EQ(job.error, GNOMON_JOB_ERROR_WATCHDOG);
  EXPECT_GE(this->system.time - begin, 5'000u);
  EXPECT_EQ(this->results(job), answers(commands));
}

TYPED_TEST(Jobs, FallBackOnTheFlagsTheyName) {
  constexpr std::uint32_t kOverflow = 1U << 8U, kOther = 1U << 9U;
  const auto engine = golden::make_golden_engine({});
  this->machine.start();
  const Words first = stream(11), second = stream(12);
  gnomon_job job = job_of(this->system, first);
  const gnomon_job fallback = job_of(this->system, second);
  job.fallback_address = fallback.address;
  job.fallback_words = fallback.words;
  job.fallback_flags = kOverflow;
  this->system.hardware.plan = {Misbehaviour{.flags = kOther}, Misbehaviour{.flags = kOverflow}};
  this->system.post(job);
  this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 2));
  EXPECT_EQ(this->system.job(0).outcome, mb::kOutcomeIsDone) << "another flag";
  EXPECT_EQ(this->system.job(0).flags & (kOverflow | kOther), kOther);
  EXPECT_EQ(this->results(this->system.job(0)), answers(*engine, first));
  answers(*engine, first);  // the first run of job 1, whose results are passed over
  const gnomon_job taken = this->system.job(1);
  EXPECT_EQ(taken.outcome, mb::kOutcomeIsFallback);
  EXPECT_EQ(taken.attempts, 2u);
  EXPECT_EQ(taken.flags & kOverflow, 0u) << "the fallback's own flags";
  EXPECT_EQ(this->results(taken), answers(*engine, second));
}

TYPED_TEST(Jobs, AFallbackIsRepeatedToo) {
  this->machine.start();
  const Words second = stream(14);
  gnomon_job job = job_of(this->system, stream(13));
  const gnomon_job fallback = job_of(this->system, second);
  job.fallback_address = fallback.address;
  job.fallback_words = fallback.words;
  job.fallback_flags = 1U << 8U;
  job.retries = 1;
  this->system.hardware.plan = {Misbehaviour{.flags = 1U << 8U},
                                Misbehaviour{.error = hw::kErrorCodeIsReadSlverr}};
  this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 1));
  EXPECT_EQ(this->system.job(0).outcome, mb::kOutcomeIsFallback);
  EXPECT_EQ(this->system.job(0).attempts, 3u);
  EXPECT_EQ(this->results(this->system.job(0)), answers(second));
}

TYPED_TEST(Jobs, WithoutSenseAreRefused) {
  this->machine.start();
  const gnomon_job good = job_of(this->system, stream(15));
  gnomon_job empty = good, odd = good, odd_fallback = good;
  empty.words = 0;
  odd.address += 4;
  odd_fallback.fallback_address = 4;
  odd_fallback.fallback_words = 1;
  for (const gnomon_job& job : {empty, odd, odd_fallback, good}) this->system.post(job);
  ASSERT_TRUE(run_jobs(this->machine, 4));
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(this->system.job(i).outcome, mb::kOutcomeIsRefused) << i;
  EXPECT_EQ(this->system.job(3).outcome, mb::kOutcomeIsDone);
  EXPECT_EQ(this->system.hardware.resets, 0u);
}

TYPED_TEST(Jobs, AResetThatDoesNotEndIsFinal) {
  this->machine.start();
  this->system.hardware.reset_never_ends = true;
  this->system.hardware.plan = {Misbehaviour{.error = hw::kErrorCodeIsReadSlverr}};
  this->system.post(job_of(this->system, stream(16)));
  EXPECT_FALSE(run_jobs(this->machine, 1));
  EXPECT_EQ(failure(this->system), mb::kFailureIsNoReset);
}

TYPED_TEST(Jobs, ABadMailboxIsFinal) {
  this->system.result_log2 = 3;
  this->system.set_up();
  this->machine.start();
  EXPECT_EQ(failure(this->system), mb::kFailureIsBadMailbox);
}

/// Jobs with faults at any place: never a wrong word in a report that says DONE or FALLBACK, never a hang.
TYPED_TEST(Jobs, RandomFaultsNeverShowAsResults) {
  constexpr std::uint32_t kJobs = 60;
  stimulus::Random random(17);
  this->machine.start();
  std::uint64_t compared = 0, faults = 0;
  for (std::uint32_t i = 0; i < kJobs; ++i) {
    const Words commands = stream(1000 + i, 15);
    gnomon_job job = job_of(this->system, commands);
    job.retries = static_cast<std::uint32_t>(random.between(0, 2));
    job.watchdog = 8'000;
    // Whatever came before, the hardware is as after power-up when it has failed once more.
    this->system.hardware.plan = {Misbehaviour{.error = static_cast<std::uint32_t>(random.between(1, 8))}};
    for (std::int64_t more = random.between(0, 2); more > 0; --more)
      this->system.hardware.plan.push_back(random.chance(30)
                                               ? Misbehaviour{.never_ends = true}
                                               : Misbehaviour{.error = hw::kErrorCodeIsTimeout});
    const std::size_t planned = this->system.hardware.plan.size();
    faults += planned;
    this->system.post(job);
    ASSERT_TRUE(run_jobs(this->machine, i + 1));
    const gnomon_job report = this->system.job(i);
    EXPECT_EQ(report.outcome, planned > job.retries ? mb::kOutcomeIsFailed : mb::kOutcomeIsDone);
    if (report.outcome == mb::kOutcomeIsDone) {
      EXPECT_EQ(this->results(report), answers(commands));
      compared += report.results_end - report.results_begin;
    }
    this->system.hardware.plan.clear();
  }
  EXPECT_GT(faults, kJobs);
  EXPECT_GT(compared, 500u);
}

}  // namespace
}  // namespace gnomon::firmware::test
