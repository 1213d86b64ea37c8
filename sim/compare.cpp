// SPDX-License-Identifier: Apache-2.0
// The reference runs one chunk of the stream ahead; whatever the hardware gives is checked against it at
// once.
#include "sim/compare.hpp"

#include <algorithm>
#include <deque>
#include <stdexcept>

namespace gnomon::sim {

namespace {

constexpr std::size_t kChunkWords = 1u << 16;

class Comparison {
 public:
  Comparison(golden::Engine& reference, RtlEngine& rtl, std::span<const Word> stream,
             const CompareOptions& options)
      : reference_(reference), rtl_(rtl), stream_(stream), options_(options) {
    report_.config = rtl.config();
    golden::CommandReader reader(stream);
    while (reader.next()) ++report_.commands;
  }

  CompareReport run() {
    try {
      run_stream();
    } catch (const HangError& error) {
      report_.fault = error.what();
    } catch (const RtlFault& error) {
      report_.fault = error.what();
    } catch (const CycleLimit& error) {
      if (!options_.keep_partial) throw;
      report_.partial = error.what();
    } catch (const Aborted& error) {
      if (!options_.keep_partial) throw;
      report_.partial = error.what();
    }
    // A hang leaves the last results in the engine.
    rtl_.poll([&](auto words, auto cycles) { check(words, cycles); });
    if (!stopped() && report_.partial.empty()) check_missing();
    report_.rtl_counters = rtl_.counters();
    report_.cycles = rtl_.cycle();
    if (report_.fault.empty() && report_.partial.empty() && !stopped()) {
      if (options_.counters) compare_counters();
      if (options_.plane) compare_planes();
    }
    return std::move(report_);
  }

 private:
  bool stopped() const { return options_.stop_at_first && report_.first.has_value(); }

  void run_stream() {
    const auto take = [&](std::span<const Word> words, std::span<const std::uint64_t> cycles) {
      check(words, cycles);
    };
    for (std::size_t offset = 0; offset < stream_.size() && !stopped(); offset += kChunkWords) {
      const auto chunk = stream_.subspan(offset, std::min(kChunkWords, stream_.size() - offset));
      reference_.submit(chunk);
      reference_.drain([&](std::span<const Word> words) {
        expected_.insert(expected_.end(), words.begin(), words.end());
        report_.expected_words += words.size();
      });
      rtl_.submit(chunk);
      rtl_.poll(take);
    }
    if (!stopped()) rtl_.drain_timed(take);
  }

  void check(std::span<const Word> words, std::span<const std::uint64_t> cycles) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::uint64_t result = report_.actual_words++;
      if (expected_.empty()) {
        note(result, std::nullopt, words[i], cycles[i]);
        continue;
      }
      const Word expected = expected_.front();
      expected_.pop_front();
      ++report_.words_compared;
      if (expected == words[i]) continue;
      ++report_.words_differing;
      note(result, expected, words[i], cycles[i]);
    }
  }

  void check_missing() {
    if (!expected_.empty()) note(report_.actual_words, expected_.front(), std::nullopt, std::nullopt);
  }

  void note(std::uint64_t result, std::optional<Word> expected, std::optional<Word> actual,
            std::optional<std::uint64_t> cycle) {
    if (report_.first) return;
    Difference difference;
    difference.result = result;
    difference.expected = expected;
    difference.actual = actual;
    difference.cycle = cycle;
    if (const auto origin = golden::find_result(stream_, result, report_.config)) {
      difference.command_index = origin->command.index;
      difference.command = origin->command.header;
      difference.item_index = origin->result;
      difference.raw_word = origin->raw_word;
      const std::uint8_t op = difference.command.op;
      const bool answers_items = op == static_cast<std::uint8_t>(golden::Op::ResolveVoxels) ||
                                 op == static_cast<std::uint8_t>(golden::slb::SlbOp::Query);
      if (answers_items && origin->result < origin->command.items.size()) {
        difference.item = origin->command.items[origin->result];
      }
    } else {
      difference.after_stream = true;
    }
    report_.first = difference;
  }

  void compare_counters() {
    const golden::Counters expected = reference_.counters();
    for (const auto& [name, count] : expected.events) {
      const auto actual = report_.rtl_counters.events.find(name);
      const std::uint64_t value = actual == report_.rtl_counters.events.end() ? 0 : actual->second;
      if (value != count) report_.counters.push_back({name, count, value});
    }
  }

  void compare_planes() {
    const std::vector<std::uint32_t> expected = reference_.read_plane();
    const std::vector<std::uint32_t> actual = rtl_.read_plane();
    if (expected.size() != actual.size()) throw std::logic_error("the planes have different sizes");
    report_.plane_entries_compared = expected.size();
    for (std::size_t i = 0; i < expected.size(); ++i)
      report_.plane_entries_differing += expected[i] != actual[i];
  }

  golden::Engine& reference_;
  RtlEngine& rtl_;
  std::span<const Word> stream_;
  CompareOptions options_;
  CompareReport report_;
  std::deque<Word> expected_;  ///< given by the reference, not yet by the hardware
};

}  // namespace

bool CompareReport::consistent() const {
  return words_differing == 0 && (expected_words == actual_words || !partial.empty()) && counters.empty() &&
         plane_entries_differing == 0 && fault.empty() && !first;
}

bool CompareReport::passed() const {
  return consistent() && words_compared > 0;
}

CompareReport compare(golden::Engine& reference, RtlEngine& rtl, std::span<const Word> stream,
                      const CompareOptions& options, std::uint32_t seed) {
  if (reference.config() != rtl.config()) throw std::invalid_argument("engines of different configurations");
  CompareReport report = Comparison(reference, rtl, stream, options).run();
  report.seed = seed;
  return report;
}

}  // namespace gnomon::sim
