// SPDX-License-Identifier: Apache-2.0
// The registers' bits. Volume II of the manual, chapters 2 and 3.
#include "sim/cpu/csr_file.hpp"

namespace gnomon::sim::cpu {
namespace {

constexpr std::uint32_t kMie = 1U << 3U, kMpie = 1U << 7U, kMppMachine = 3U << 11U;
constexpr std::uint32_t kRv32 = 1U << 30U;
constexpr std::uint32_t kMisa = kRv32 | 1U << ('I' - 'A') | 1U << ('M' - 'A') | 1U << ('C' - 'A');
constexpr std::uint32_t kVectored = 1;

constexpr std::uint32_t bit(Interrupt line) {
  return 1U << static_cast<unsigned>(line);
}
constexpr std::uint32_t kLines = bit(Interrupt::Software) | bit(Interrupt::Timer) | bit(Interrupt::External);

constexpr std::uint32_t low(std::uint64_t value) {
  return static_cast<std::uint32_t>(value);
}
constexpr std::uint32_t high(std::uint64_t value) {
  return static_cast<std::uint32_t>(value >> 32U);
}
constexpr std::uint64_t with_low(std::uint64_t value, std::uint32_t part) {
  return value >> 32U << 32U | part;
}
constexpr std::uint64_t with_high(std::uint64_t value, std::uint32_t part) {
  return std::uint64_t{part} << 32U | low(value);
}

constexpr bool between(Csr csr, Csr first, Csr last) {
  return first <= csr && csr <= last;
}
/// Counters and events that are there, but count nothing.
constexpr bool reads_zero(Csr csr) {
  return between(csr, Csr::Mhpmevent3, Csr::Mhpmevent31) ||
         between(csr, Csr::Mhpmcounter3, Csr::Mhpmcounter31) ||
         between(csr, Csr::Mhpmcounter3h, Csr::Mhpmcounter31h) || csr == Csr::Mcountinhibit ||
         csr == Csr::Mstatush;
}
/// The number itself says so.
constexpr bool read_only(std::uint32_t number) {
  return (number >> 10U & 3U) == 3U;
}

}  // namespace

std::optional<std::uint32_t> CsrFile::read(std::uint32_t number, const Counters& now) const {
  const auto csr = static_cast<Csr>(number);
  const std::uint64_t cycles = now.cycles + cycle_offset_;
  const std::uint64_t instructions = now.instructions + instret_offset_;
  switch (csr) {
    case Csr::Mstatus:
      return mstatus();
    case Csr::Misa:
      return kMisa;
    case Csr::Mie:
      return mie_;
    case Csr::Mip:
      return mip_;
    case Csr::Mtvec:
      return mtvec_;
    case Csr::Mscratch:
      return mscratch_;
    case Csr::Mepc:
      return mepc_;
    case Csr::Mcause:
      return mcause_;
    case Csr::Mtval:
      return mtval_;
    case Csr::Mcycle:
    case Csr::Cycle:
      return low(cycles);
    case Csr::Mcycleh:
    case Csr::Cycleh:
      return high(cycles);
    case Csr::Minstret:
    case Csr::Instret:
      return low(instructions);
    case Csr::Minstreth:
    case Csr::Instreth:
      return high(instructions);
    case Csr::Mvendorid:
    case Csr::Marchid:
    case Csr::Mimpid:
    case Csr::Mhartid:
    case Csr::Mconfigptr:
      return 0;
    default:
      break;
  }
  if (reads_zero(csr)) return 0;
  return std::nullopt;
}

bool CsrFile::write(std::uint32_t number, std::uint32_t value, const Counters& now) {
  if (read_only(number)) return false;
  const auto csr = static_cast<Csr>(number);
  switch (csr) {
    case Csr::Mstatus:
      mstatus_mie_ = (value & kMie) != 0;
      mstatus_mpie_ = (value & kMpie) != 0;
      return true;
    case Csr::Misa:
    case Csr::Mip:
      return true;
    case Csr::Mie:
      mie_ = value & kLines;
      return true;
    case Csr::Mtvec:
      mtvec_ = value & ~2U;
      return true;
    case Csr::Mscratch:
      mscratch_ = value;
      return true;
    case Csr::Mepc:
      mepc_ = value & ~1U;
      return true;
    case Csr::Mcause:
      mcause_ = value;
      return true;
    case Csr::Mtval:
      mtval_ = value;
      return true;
    default:
      return reads_zero(csr) || write_counter(csr, value, now);
  }
}

/// The writing instruction itself will be counted; what it writes is what the next one reads.
bool CsrFile::write_counter(Csr csr, std::uint32_t value, const Counters& now) {
  const std::uint64_t cycles = now.cycles + cycle_offset_;
  const std::uint64_t instructions = now.instructions + instret_offset_;
  switch (csr) {
    case Csr::Mcycle:
      cycle_offset_ = with_low(cycles, value) - (now.cycles + 1);
      return true;
    case Csr::Mcycleh:
      cycle_offset_ = with_high(cycles, value) - (now.cycles + 1);
      return true;
    case Csr::Minstret:
      instret_offset_ = with_low(instructions, value) - (now.instructions + 1);
      return true;
    case Csr::Minstreth:
      instret_offset_ = with_high(instructions, value) - (now.instructions + 1);
      return true;
    default:
      return false;
  }
}

std::uint32_t CsrFile::mstatus() const {
  return kMppMachine | (mstatus_mie_ ? kMie : 0U) | (mstatus_mpie_ ? kMpie : 0U);
}

std::uint32_t CsrFile::save(std::uint32_t cause, std::uint32_t pc, std::uint32_t value) {
  mepc_ = pc;
  mcause_ = cause;
  mtval_ = value;
  mstatus_mpie_ = mstatus_mie_;
  mstatus_mie_ = false;
  return mtvec_ & ~3U;
}

std::uint32_t CsrFile::enter(Cause cause, std::uint32_t pc, std::uint32_t value) {
  return save(static_cast<std::uint32_t>(cause), pc, value);
}

std::uint32_t CsrFile::enter(Interrupt interrupt, std::uint32_t pc) {
  const auto code = static_cast<std::uint32_t>(interrupt);
  const std::uint32_t base = save(1U << 31U | code, pc, 0);
  return (mtvec_ & kVectored) != 0 ? base + 4 * code : base;
}

std::uint32_t CsrFile::leave() {
  mstatus_mie_ = mstatus_mpie_;
  mstatus_mpie_ = true;
  return mepc_;
}

void CsrFile::set_line(Interrupt line, bool level) {
  mip_ = level ? mip_ | bit(line) : mip_ & ~bit(line);
}

Interrupt CsrFile::first_interrupt() const {
  for (const Interrupt line : {Interrupt::External, Interrupt::Software})
    if ((mip_ & mie_ & bit(line)) != 0) return line;
  return Interrupt::Timer;
}

void CsrFile::reset() {
  const std::uint32_t lines = mip_;
  *this = CsrFile{};
  mip_ = lines;
}

}  // namespace gnomon::sim::cpu
