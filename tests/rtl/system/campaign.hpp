// SPDX-License-Identifier: Apache-2.0
// Random faults in the middle of jobs: what the hardware says of them, and whether it is right afterwards.
#pragma once

#include <array>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "jobs.hpp"

namespace gnomon::rtl_test {

/// Of a campaign. Everything in the second line must be 0.
struct Tally {
  unsigned rounds = 0, completed = 0, stopped = 0, resets_in_jobs = 0, late = 0, late_timeouts = 0;
  unsigned hangs = 0, wrong_words = 0, wrong_reports = 0, not_recovered = 0, assertions = 0;
  std::size_t words = 0;  ///< compared
  std::array<unsigned, 9> codes{};

  bool clean() const { return hangs + wrong_words + wrong_reports + not_recovered + assertions == 0; }
  std::string text() const;
};

inline std::string Tally::text() const {
  std::ostringstream all;
  all << rounds << " faults: " << completed << " jobs completed, " << stopped << " stopped (codes";
  for (const unsigned code : codes) all << " " << code;
  all << "), " << resets_in_jobs << " resets in jobs, " << late << " with late answers, " << late_timeouts
      << " timeouts after a reset; " << words << " words compared; " << hangs << " hangs, " << wrong_words
      << " wrong words, " << wrong_reports << " wrong reports, " << not_recovered << " not recovered, "
      << assertions << " assertions";
  return all.str();
}

template <class Model>
class Campaign {
 public:
  Campaign(const golden::HardwareConfig& config, std::uint32_t seed, const std::string& plusarg = {})
      : config_(config), random_(seed), seed_(seed * 100'000ULL), bench_(seed, plusarg), reference_(config) {}

  /// Rounds until so many are done, or until something is wrong that a mutant should show.
  const Tally& run(unsigned rounds, bool stop_at_first = false) {
    for (unsigned i = 0; i < rounds && !(stop_at_first && !tally_.clean()); ++i) {
      round();
      ++tally_.rounds;
      if (bench_.asserted()) {
        ++tally_.assertions;
        break;
      }
    }
    return tally_;
  }

 private:
  enum class Heal : std::uint8_t { BeforeReset, DuringReset, DuringNextJob, AfterNextJob };
  static constexpr std::array kFaults{Fault::None,          Fault::ReadSlverr,       Fault::ReadDecerr,
                                      Fault::WriteSlverr,   Fault::WriteDecerr,      Fault::ReadSilent,
                                      Fault::WriteSilent,   Fault::ReadAddressStuck, Fault::WriteAddressStuck,
                                      Fault::WriteDataStuck};

  unsigned pick(unsigned count) { return static_cast<unsigned>(random_() % count); }

  void round() {
    const Fault fault = kFaults.at(pick(kFaults.size()));
    const bool reset_in_job = fault == Fault::None || pick(8) == 0;
    bench_.memory().set_timing({1, 1 + pick(40), 100 + pick(157), pick(2) != 0});
    if (fault != Fault::None) bench_.memory().inject(fault, pick(16));
    start();
    if (reset_in_job)
      begin_job();
    else
      faulty_job(fault);
    bench_.memory().disarm();
    const auto heal = static_cast<Heal>(pick(4));
    recover(heal);
    // Two more at most: the next job may still meet a channel that is stuck.
    bool right = clean_job(heal);
    if (!right) {
      ++tally_.late_timeouts;
      bench_.memory().heal();
      recover(Heal::BeforeReset);
      right = clean_job(Heal::BeforeReset);
    }
    if (!right) ++tally_.not_recovered;
    bench_.memory().heal();
    reset();
  }

  void start() {
    rings_.base = Rings{}.base + (half_ ? TopBench<Model>::kMemoryBytes / 2 : 0);
    bench_.start(rings_, 200 + pick(200), pick(1000));
  }

  std::vector<Word> next_job() {
    std::vector<Word> words = random_job(config_, ++seed_, 12);
    expected_ = reference_.run(words);
    job_ = static_cast<std::uint16_t>(seed_ % 60'000);
    bench_.submit(words, job_, 1 + pick(3), pick(512));
    return words;
  }

  void begin_job() {
    next_job();
    bench_.run(pick(1500));
    ++tally_.resets_in_jobs;
  }

  void faulty_job(Fault fault) {
    next_job();
    std::vector<Word> results;
    if (!bench_.wait(results)) {
      if (!bench_.asserted()) ++tally_.hangs;
      return;
    }
    if (bench_.stopped()) {
      ++tally_.stopped;
      check_report(fault);
    } else {
      ++tally_.completed;
      if (results.size() != expected_.size()) ++tally_.wrong_words;
    }
    compare(results);
  }

  /// Results that were counted are right, those of a job that stopped too.
  void compare(const std::vector<Word>& results) {
    for (std::size_t i = 0; i < results.size(); ++i, ++tally_.words) {
      if (i >= expected_.size() || results[i] != expected_[i]) ++tally_.wrong_words;
    }
  }

  void check_report(Fault fault) {
    const std::uint32_t status = bench_.read(hw::kErrorStatusOffset), code = status & 0xFF,
                        job = status >> 16;
    ++tally_.codes.at(code < 9 ? code : 0);
    const std::array<std::uint32_t, kFaults.size()> codes{0,
                                                          hw::kErrorCodeIsReadSlverr,
                                                          hw::kErrorCodeIsReadDecerr,
                                                          hw::kErrorCodeIsWriteSlverr,
                                                          hw::kErrorCodeIsWriteDecerr,
                                                          hw::kErrorCodeIsTimeout,
                                                          hw::kErrorCodeIsTimeout,
                                                          hw::kErrorCodeIsTimeout,
                                                          hw::kErrorCodeIsTimeout,
                                                          hw::kErrorCodeIsTimeout};
    const std::uint32_t expected = codes.at(static_cast<std::size_t>(fault));
    const std::uint64_t address = bench_.read(hw::kErrorAddressLowOffset) |
                                  std::uint64_t{bench_.read(hw::kErrorAddressHighOffset)} << 32;
    constexpr std::uint64_t kBeat = TopBench<Model>::kBeatBytes;
    const bool named =
        address / kBeat * kBeat == bench_.memory().fault_address() || expected == hw::kErrorCodeIsTimeout;
    if (code != expected || !named || (job != job_ && job != 0xFFFF)) ++tally_.wrong_reports;
  }

  void recover(Heal heal) {
    if (heal == Heal::BeforeReset) bench_.memory().heal();
    bench_.write(hw::kResetOffset, hw::kResetSoftResetMask);
    if (heal == Heal::DuringReset) {
      bench_.run(pick(300));
      bench_.memory().heal();
    }
    reset();
  }

  void reset() {
    if (!bench_.reset()) ++tally_.not_recovered;
    reference_.reset();
    const std::uint32_t status = bench_.read(hw::kStatusOffset);
    const bool late = (status & hw::kStatusLateMask) != 0;
    // Nothing is under way that the hardware does not know of.
    if (!late && !bench_.memory().quiet()) ++tally_.wrong_reports;
    if ((status & ~hw::kStatusLateMask) != hw::kStatusIdleMask) ++tally_.wrong_reports;
    if (late) {
      ++tally_.late;
      half_ = !half_;  // what is written late must not meet the next job
    }
  }

  /// False if it stopped by TIMEOUT because the memory still does not move.
  bool clean_job(Heal heal) {
    start();
    next_job();
    std::vector<Word> results;
    if (heal == Heal::DuringNextJob) {
      bench_.run(pick(600));
      bench_.memory().heal();
    }
    if (!bench_.wait(results)) {
      if (!bench_.asserted()) ++tally_.hangs;
      return false;
    }
    compare(results);
    if (!bench_.stopped()) {
      if (results.size() != expected_.size()) ++tally_.wrong_words;
      return true;
    }
    if ((bench_.read(hw::kErrorStatusOffset) & 0xFF) != hw::kErrorCodeIsTimeout) ++tally_.wrong_reports;
    return false;
  }

  golden::HardwareConfig config_;
  std::mt19937 random_;
  std::uint64_t seed_;
  TopBench<Model> bench_;
  Reference reference_;
  std::vector<Word> expected_;
  std::uint16_t job_ = 0;
  Rings rings_;
  bool half_ = false;
  Tally tally_;
};

}  // namespace gnomon::rtl_test
