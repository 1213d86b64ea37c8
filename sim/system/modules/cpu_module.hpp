// SPDX-License-Identifier: Apache-2.0
// The processor on the bus, ahead of the others by at most a quantum (docs/system-model.md).
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "sim/cpu/rv32_core.hpp"

namespace gnomon::sim::system {

/// What the processor's bus has seen.
struct CpuTraffic {
  std::uint64_t register_reads = 0, register_writes = 0, memory_accesses = 0;
  /// Awake, from a read of a register to the next one, if that was of the same register and told nothing new.
  std::uint64_t cycles_polling = 0;
};

class CpuModule : public sc_core::sc_module, private cpu::Bus {
 public:
  /// Throws std::invalid_argument if the image does not fit.
  CpuModule(const sc_core::sc_module_name& name, std::span<const std::uint8_t> image,
            std::uint32_t quantum_cycles);

  tlm_utils::simple_initiator_socket<CpuModule> socket;
  sc_core::sc_in<bool> external, software, timer;

  cpu::Counters counters() const { return core_.counters(); }
  const CpuTraffic& traffic() const { return traffic_; }

  static constexpr std::uint32_t kProgramBytes = 65536;

 private:
  cpu::Reply read(std::uint32_t address, unsigned bytes, cpu::Access access) override;
  cpu::Reply write(std::uint32_t address, unsigned bytes, std::uint32_t data) override;
  cpu::Reply transfer(tlm::tlm_command command, std::uint32_t address, unsigned bytes, std::uint32_t data);
  void run();
  void sleep();
  /// Lets the others catch up.
  void synchronise();
  void sample_lines();
  void note_polling(tlm::tlm_command command, std::uint32_t address, std::uint32_t data);
  /// Cycles that the processor is ahead.
  std::uint64_t ahead() const { return core_.counters().cycles - synchronised_; }

  std::uint32_t quantum_;
  std::vector<std::uint8_t> program_;
  cpu::Rv32Core core_;
  std::uint64_t synchronised_ = 0;
  CpuTraffic traffic_;
  /// The last access to a register, if it was a read.
  struct RegisterRead {
    std::uint32_t address = 0, data = 0;
    std::uint64_t awake = 0;  ///< cycles till then
  };
  std::optional<RegisterRead> last_read_;
};

}  // namespace gnomon::sim::system
