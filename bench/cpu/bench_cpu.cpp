// SPDX-License-Identifier: Apache-2.0
// How many instructions a second the simulated processor executes.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "sim/cpu/rv32_core.hpp"

namespace gnomon::sim::cpu {
namespace {

struct Memory final : Bus {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(4096);
  Reply read(std::uint32_t address, unsigned size, Access) override {
    if (address > bytes.size() - size) return {0, 0, true};
    Reply reply;
    std::memcpy(&reply.data, &bytes[address], size);
    return reply;
  }
  Reply write(std::uint32_t address, unsigned size, std::uint32_t data) override {
    if (address > bytes.size() - size) return {0, 0, true};
    std::memcpy(&bytes[address], &data, size);
    return {};
  }
};

// A loop of loads, stores, multiplications and branches, as in firmware.
constexpr std::array<std::uint32_t, 9> kLoop{
    0x40000093,  // li   x1, 0x400
    0x0000A183,  // lw   x3, 0(x1)
    0x00118193,  // addi x3, x3, 1
    0x0030A223,  // sw   x3, 4(x1)
    0x02218233,  // mul  x4, x3, x2
    0xFFF10113,  // addi x2, x2, -1
    0x00328293,  // addi x5, x5, 3
    0xFE0114E3,  // bnez x2, -24
    0xFE5FF06F,  // j    -28
};

void run_loop(benchmark::State& state) {
  Memory memory;
  std::memcpy(memory.bytes.data(), kLoop.data(), sizeof kLoop);
  Rv32Core core(memory);
  for ([[maybe_unused]] auto round : state) core.run(1'000'000);
  if (core.counters().exceptions != 0) state.SkipWithError("the loop has trapped");
  state.SetItemsProcessed(state.iterations() * 1'000'000);
}
BENCHMARK(run_loop)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon::sim::cpu

BENCHMARK_MAIN();
