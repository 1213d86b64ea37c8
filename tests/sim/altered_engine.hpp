// SPDX-License-Identifier: Apache-2.0
// A reference that lies in one place, for tests of what is supposed to notice.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <vector>

namespace gnomon::sim::test {

using golden::Word;

/// What becomes of result word `index` (from 0): any number of words.
using Alteration = std::function<std::vector<Word>(std::uint64_t index, Word word)>;

inline Alteration flip_bit(std::uint64_t at, int bit) {
  return [=](std::uint64_t index, Word word) {
    return std::vector<Word>{index == at ? word ^ (Word{1} << bit) : word};
  };
}
inline Alteration drop(std::uint64_t at) {
  return [=](std::uint64_t index, Word word) {
    return index == at ? std::vector<Word>{} : std::vector<Word>{word};
  };
}
inline Alteration repeat(std::uint64_t at) {
  return [=](std::uint64_t index, Word word) {
    return index == at ? std::vector<Word>{word, word} : std::vector<Word>{word};
  };
}

/// Passes everything on to another engine and alters its answers.
class AlteredEngine final : public golden::Engine {
 public:
  AlteredEngine(std::unique_ptr<golden::Engine> engine, Alteration words)
      : engine_(std::move(engine)), words_(std::move(words)) {}

  /// Event to be reported one too high.
  void miscount(std::string event) { event_ = std::move(event); }
  /// Plane entry to be reported wrong.
  void misread(std::size_t entry) { entry_ = static_cast<std::int64_t>(entry); }

  std::string_view name() const override { return engine_->name(); }
  const golden::HardwareConfig& config() const override { return engine_->config(); }
  void submit(std::span<const Word> words) override { engine_->submit(words); }
  void drain(const golden::ResultSink& sink) override {
    engine_->drain([&](std::span<const Word> words) {
      for (const Word word : words) sink(words_(index_++, word));
    });
  }
  golden::Counters counters() const override {
    golden::Counters counters = engine_->counters();
    if (!event_.empty()) ++counters.events.at(event_);
    return counters;
  }
  void reset() override {
    engine_->reset();
    index_ = 0;
  }
  std::vector<std::uint32_t> read_plane() override {
    std::vector<std::uint32_t> plane = engine_->read_plane();
    if (entry_ >= 0) plane.at(static_cast<std::size_t>(entry_)) ^= 1;
    return plane;
  }

 private:
  std::unique_ptr<golden::Engine> engine_;
  Alteration words_;
  std::uint64_t index_ = 0;
  std::string event_;
  std::int64_t entry_ = -1;
};

}  // namespace gnomon::sim::test
