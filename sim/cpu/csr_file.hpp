// SPDX-License-Identifier: Apache-2.0
// Control and status registers of machine mode; trap entry and return (docs/cpu.md).
#pragma once

#include <cstdint>
#include <optional>

#include "sim/cpu/iss.hpp"

namespace gnomon::sim::cpu {

enum class Csr : std::uint16_t {
  Mstatus = 0x300,
  Misa = 0x301,
  Mie = 0x304,
  Mtvec = 0x305,
  Mstatush = 0x310,
  Mcountinhibit = 0x320,
  Mhpmevent3 = 0x323,
  Mhpmevent31 = 0x33F,
  Mscratch = 0x340,
  Mepc = 0x341,
  Mcause = 0x342,
  Mtval = 0x343,
  Mip = 0x344,
  Mcycle = 0xB00,
  Minstret = 0xB02,
  Mhpmcounter3 = 0xB03,
  Mhpmcounter31 = 0xB1F,
  Mcycleh = 0xB80,
  Minstreth = 0xB82,
  Mhpmcounter3h = 0xB83,
  Mhpmcounter31h = 0xB9F,
  Cycle = 0xC00,
  Instret = 0xC02,
  Cycleh = 0xC80,
  Instreth = 0xC82,
  Mvendorid = 0xF11,
  Marchid = 0xF12,
  Mimpid = 0xF13,
  Mhartid = 0xF14,
  Mconfigptr = 0xF15,
};

/// Exceptions by the manual's cause numbers.
enum class Cause : std::uint32_t {
  FetchFault = 1,
  Illegal = 2,
  Breakpoint = 3,
  LoadMisaligned = 4,
  LoadFault = 5,
  StoreMisaligned = 6,
  StoreFault = 7,
  EnvironmentCall = 11,
};

class CsrFile {
 public:
  /// Nothing if there is no such register. `now` are the counters before the instruction that reads.
  std::optional<std::uint32_t> read(std::uint32_t number, const Counters& now) const;
  /// False if there is no such register or it can only be read.
  bool write(std::uint32_t number, std::uint32_t value, const Counters& now);

  /// Saves pc and the reason, switches interrupts off; returns where to go on.
  std::uint32_t enter(Cause cause, std::uint32_t pc, std::uint32_t value);
  std::uint32_t enter(Interrupt interrupt, std::uint32_t pc);
  /// mret: switches interrupts back; returns where to go on.
  std::uint32_t leave();

  void set_line(Interrupt line, bool level);
  /// What wakes from wfi: a line that mie admits.
  bool wakes() const { return (mip_ & mie_) != 0; }
  /// Whether a trap is to be taken now.
  bool interrupts() const { return mstatus_mie_ && wakes(); }
  /// The one that comes first. Only when interrupts().
  Interrupt first_interrupt() const;
  /// As after power-up; lines stay.
  void reset();

 private:
  std::uint32_t mstatus() const;
  std::uint32_t save(std::uint32_t cause, std::uint32_t pc, std::uint32_t value);
  bool write_counter(Csr csr, std::uint32_t value, const Counters& now);

  bool mstatus_mie_ = false, mstatus_mpie_ = false;
  std::uint32_t mie_ = 0, mip_ = 0;
  std::uint32_t mtvec_ = 0, mscratch_ = 0, mepc_ = 0, mcause_ = 0, mtval_ = 0;
  // What software has added to the counters by writing them.
  std::uint64_t cycle_offset_ = 0, instret_offset_ = 0;
};

}  // namespace gnomon::sim::cpu
