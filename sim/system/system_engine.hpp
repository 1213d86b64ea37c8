// SPDX-License-Identifier: Apache-2.0
// The whole system behind the interface of an engine.
#pragma once

#include <gnomon/golden/engine.hpp>
#include <memory>
#include <span>
#include <vector>

#include "sim/system/system_top.hpp"

namespace gnomon::sim::system {

/// What is submitted until a drain is one job, so it must hold whole commands. One at a time in a process.
class SystemEngine final : public golden::Engine {
 public:
  /// `inner` answers the commands inside the hardware; `clock` and exceptions as of System.
  SystemEngine(const SystemConfig& config, std::unique_ptr<golden::Engine> inner,
               std::span<const std::uint8_t> firmware, EngineClock clock = {});

  std::string_view name() const override { return "system"; }
  const golden::HardwareConfig& config() const override { return inner_->config(); }
  void submit(std::span<const golden::Word> words) override;
  /// Throws std::runtime_error with the report's error if the job fails.
  void drain(const golden::ResultSink& sink) override;
  golden::Counters counters() const override { return inner_->counters(); }
  /// The hardware's engine alone; firmware and time go on.
  void reset() override;
  std::vector<std::uint32_t> read_plane() override { return inner_->read_plane(); }

  const System& system() const { return system_; }

 private:
  std::unique_ptr<golden::Engine> inner_;
  System system_;
  std::vector<golden::Word> waiting_;
};

}  // namespace gnomon::sim::system
