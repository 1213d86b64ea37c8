// SPDX-License-Identifier: Apache-2.0
// The Verilated gnomon_top: registers on one side, memory on the other, an interrupt line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "sim/model_cache.hpp"

namespace gnomon::sim {

/// A model in reset state, cycle by cycle; one owner at a time. Who drives it answers each read and write of
/// the master, in an order and at cycles of its choice, or never.
class TopModel {
 public:
  /// `seed`: of the random content of registers and memories at power-up.
  TopModel(std::shared_ptr<const TopLibrary> library, std::uint32_t seed)
      : library_(std::move(library)), api_(library_->api()), model_(api_.create(seed), api_.destroy) {}

  /// Until cycle `until` is reached (0) or something has happened (a set of GnomonTopEvent). Throws RtlFault
  /// where an assertion of the RTL failed.
  int run(std::uint64_t until);
  /// Cycles since reset.
  std::uint64_t cycle() const { return api_.cycle(model_.get()); }
  bool interrupt() const { return api_.interrupt(model_.get()) != 0; }

  /// Begins an access to a register; one at a time. GNOMON_TOP_ACCESS tells of its end.
  void begin_read(std::uint32_t offset) { api_.begin_access(model_.get(), 0, offset, 0); }
  void begin_write(std::uint32_t offset, std::uint32_t data) {
    api_.begin_access(model_.get(), 1, offset, data);
  }
  /// True: OKAY, and in `data` what was read; false: SLVERR.
  bool end_access(std::uint32_t& data) const { return api_.end_access(model_.get(), &data) == 0; }

  bool take(GnomonTopRead& read) { return api_.take_read(model_.get(), &read) != 0; }
  bool take(GnomonTopWrite& write) { return api_.take_write(model_.get(), &write) != 0; }
  /// AXI's codes: 0 OKAY, 2 SLVERR, 3 DECERR. Each channel gives its answers in the order of these calls.
  void answer(const GnomonTopRead& read, std::uint64_t cycle, std::span<const std::uint8_t> data,
              int response) {
    api_.answer_read(model_.get(), &read, cycle, data.data(), response);
  }
  void answer(const GnomonTopWrite& write, std::uint64_t cycle, int response) {
    api_.answer_write(model_.get(), &write, cycle, response);
  }

  /// Throws std::runtime_error if the file cannot be written, or the model was built without waveforms.
  void open_trace(const std::filesystem::path& file, std::uint64_t from, std::uint64_t to);
  void close_trace() { api_.trace_close(model_.get()); }

 private:
  std::shared_ptr<const TopLibrary> library_;
  const GnomonTopApi& api_;
  std::unique_ptr<void, void (*)(void*)> model_;
};

}  // namespace gnomon::sim
