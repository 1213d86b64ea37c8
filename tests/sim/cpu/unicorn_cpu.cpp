// SPDX-License-Identifier: Apache-2.0
// Unicorn's C interface.
#include "tests/sim/cpu/unicorn_cpu.hpp"

#include <unicorn/unicorn.h>

#include <array>
#include <stdexcept>
#include <string>

#include "tests/sim/cpu/flat_memory.hpp"

namespace gnomon::sim::cpu::test {
namespace {

constexpr std::uint32_t kNoException = ~0U;

template <class Close>
uc_engine* get(const std::unique_ptr<void, Close>& engine) {
  return static_cast<uc_engine*>(engine.get());
}
void must(uc_err error) {
  if (error != UC_ERR_OK) throw std::runtime_error(std::string("unicorn: ") + uc_strerror(error));
}
void on_exception(uc_engine* engine, std::uint32_t cause, void* result) {
  *static_cast<std::uint32_t*>(result) = cause;
  uc_emu_stop(engine);
}

Outcome outcome(uc_err error, std::uint32_t cause) {
  if (cause == 2) return Outcome::Illegal;
  if (cause == 3) return Outcome::Breakpoint;
  if (cause >= 8 && cause <= 11) return Outcome::EnvironmentCall;
  if (cause != kNoException) return Outcome::Other;
  switch (error) {
    case UC_ERR_OK:
    case UC_ERR_FETCH_UNMAPPED:  // of the next instruction: it looks ahead
    case UC_ERR_FETCH_PROT:
      return Outcome::Done;
    case UC_ERR_INSN_INVALID:
      return Outcome::Breakpoint;  // its way to say so; illegal ones are cause 2
    case UC_ERR_READ_UNMAPPED:
    case UC_ERR_WRITE_UNMAPPED:
    case UC_ERR_WRITE_PROT:
      return Outcome::MemoryFault;
    default:
      return Outcome::Other;
  }
}

}  // namespace

void UnicornCpu::Close::operator()(void* engine) const {
  uc_close(static_cast<uc_engine*>(engine));
}

UnicornCpu::UnicornCpu() {
  uc_engine* engine = nullptr;
  must(uc_open(UC_ARCH_RISCV, UC_MODE_RISCV32, &engine));
  engine_.reset(engine);
  must(uc_mem_map(engine, kCodeBase, kCodeSize, UC_PROT_READ | UC_PROT_EXEC));
  must(uc_mem_map(engine, kDataBase, kDataSize, UC_PROT_READ | UC_PROT_WRITE));
}

void UnicornCpu::put_code(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  must(uc_ctl_remove_cache(get(engine_), address, address + bytes.size()));
  must(uc_mem_write(get(engine_), address, bytes.data(), bytes.size()));
}

void UnicornCpu::put_data(std::span<const std::uint8_t> bytes) {
  must(uc_mem_write(get(engine_), kDataBase, bytes.data(), bytes.size()));
}

std::vector<std::uint8_t> UnicornCpu::data(std::uint32_t address, std::uint32_t bytes) const {
  std::vector<std::uint8_t> result(bytes);
  must(uc_mem_read(get(engine_), address, result.data(), bytes));
  return result;
}

void UnicornCpu::set_state(const HartState& state) {
  for (int i = 1; i < 32; ++i)
    must(uc_reg_write(get(engine_), UC_RISCV_REG_X0 + i, &state.x[static_cast<std::size_t>(i)]));
  pc_ = state.pc;
}

HartState UnicornCpu::state() const {
  HartState state;
  for (int i = 1; i < 32; ++i)
    must(uc_reg_read(get(engine_), UC_RISCV_REG_X0 + i, &state.x[static_cast<std::size_t>(i)]));
  state.pc = pc_;
  return state;
}

Outcome UnicornCpu::step() {
  std::uint32_t cause = kNoException;
  uc_hook hook = 0;
  void (*const callback)(uc_engine*, std::uint32_t, void*) = on_exception;
  must(uc_hook_add(get(engine_), &hook, UC_HOOK_INTR, reinterpret_cast<void*>(callback), &cause, 1, 0));
  const uc_err error = uc_emu_start(get(engine_), pc_, 0, 0, 1);
  must(uc_hook_del(get(engine_), hook));
  const Outcome result = outcome(error, cause);
  if (result == Outcome::Done) must(uc_reg_read(get(engine_), UC_RISCV_REG_PC, &pc_));
  return result;
}

}  // namespace gnomon::sim::cpu::test
