// SPDX-License-Identifier: Apache-2.0
// The hardware's registers as docs/system.md says: what may be written when, interrupts, stop, reset. Without
// time.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <optional>

#include "sim/registers/register_file.hpp"

namespace gnomon::sim::system {

/// What a write asks of the device.
enum class Request : std::uint8_t { None, Refused, Start, Reset, Snapshot };

class DeviceRegisters {
 public:
  explicit DeviceRegisters(const golden::HardwareConfig& config);

  /// Nothing: SLVERR.
  std::optional<std::uint32_t> read(std::uint32_t offset) const { return file_.read(offset); }
  /// Refused: SLVERR. Start: something has changed that may let work begin or go on.
  Request write(std::uint32_t offset, std::uint32_t value);

  /// The device's side.
  std::uint32_t get(std::uint32_t offset) const { return file_.get(offset); }
  std::uint64_t get_address(std::uint32_t low_offset) const;
  void set(std::uint32_t offset, std::uint32_t value) { file_.set(offset, value); }
  void set_busy(bool busy);
  void set_result_blocked(bool blocked);
  /// Raises interrupt status bits.
  void raise(std::uint32_t bits);
  /// Stops with an error (the first counts); `job` 0xFFFF outside of any.
  void stop(std::uint32_t code, std::uint16_t job, std::uint64_t address);
  void reset();
  /// Copies the engine's event counters into the window.
  void snapshot(const golden::Counters& counters);

  bool enabled() const;
  bool stopped() const;
  bool interrupt() const;
  /// Writes that came at a time when set-up is frozen.
  std::uint64_t untimely_writes() const { return untimely_writes_; }

 private:
  bool untimely(std::uint32_t offset) const;
  void set_status(std::uint32_t mask, bool value);
  void describe_build();

  golden::HardwareConfig config_;
  registers::RegisterFile file_;
  std::uint64_t untimely_writes_ = 0;
};

}  // namespace gnomon::sim::system
