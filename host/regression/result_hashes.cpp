// SPDX-License-Identifier: Apache-2.0
// A golden engine that shows its words to a listener.
#include "host/regression/result_hashes.hpp"

#include <gnomon/golden/golden_engine.hpp>
#include <memory>
#include <utility>

#include "sim/content_hash.hpp"

namespace gnomon::regression {
namespace {

class HeardEngine final : public golden::Engine {
 public:
  HeardEngine(std::unique_ptr<golden::Engine> engine, std::string& bytes)
      : engine_(std::move(engine)), bytes_(bytes) {}

  std::string_view name() const override { return engine_->name(); }
  const golden::HardwareConfig& config() const override { return engine_->config(); }
  void submit(std::span<const golden::Word> words) override { engine_->submit(words); }
  void drain(const golden::ResultSink& sink) override {
    engine_->drain([&](std::span<const golden::Word> words) {
      for (const golden::Word word : words) {
        for (int shift = 0; shift < 64; shift += 8) bytes_.push_back(static_cast<char>(word >> shift & 0xFF));
      }
      sink(words);
    });
  }
  golden::Counters counters() const override { return engine_->counters(); }
  void reset() override { engine_->reset(); }
  std::vector<std::uint32_t> read_plane() override { return engine_->read_plane(); }

 private:
  std::unique_ptr<golden::Engine> engine_;
  std::string& bytes_;
};

}  // namespace

pipeline::GoldenFactory ResultHashes::factory() {
  return [this](const golden::HardwareConfig& config) -> std::unique_ptr<golden::Engine> {
    return std::make_unique<HeardEngine>(golden::make_golden_engine(config), bytes_.emplace_back());
  };
}

std::vector<std::string> ResultHashes::hashes() const {
  std::vector<std::string> hashes;
  for (const std::string& bytes : bytes_) hashes.push_back(sim::content_hash(bytes));
  return hashes;
}

}  // namespace gnomon::regression
