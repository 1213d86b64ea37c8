// SPDX-License-Identifier: Apache-2.0
// The parameters of the simulated system.
#include "host/cli/system_settings.hpp"

#include <algorithm>
#include <bit>
#include <string_view>

namespace gnomon::cli {

namespace {

sim::system::HardwareModel hardware_of(const std::string& word) {
  using enum sim::system::HardwareModel;
  return word == "golden" ? Golden : word == "core" ? Core : Top;
}

}  // namespace

sim::system::SystemOptions system_settings(const config::Settings& settings) {
  const auto integer = [&](std::string_view key) {
    return static_cast<std::uint32_t>(settings.integer(key));
  };
  sim::system::SystemOptions options;
  options.hardware = hardware_of(settings.word("system_hardware"));
  // The registry takes 0 and powers of two only.
  if (const std::uint32_t kib = integer("cache_kib"); kib > 0)
    options.cache_log2 = 10 + std::countr_zero(kib);
  options.line_ids_log2 = std::countr_zero(integer("line_ids"));
  options.axi_data_bits = static_cast<int>(integer("axi_bits"));
  sim::system::SystemConfig& system = options.system;
  system.dram_bytes = std::uint64_t{integer("dram_mib")} << 20U;
  system.dram.latency = integer("memory_latency");
  system.dram.banks = integer("dram_banks");
  system.dram.row_bytes = integer("dram_row_bytes");
  system.dram.t_rcd = integer("dram_rcd");
  system.dram.t_rp = integer("dram_rp");
  system.dram.t_cas = integer("dram_cas");
  system.dram.bytes_per_cycle = integer("dram_width");
  system.bus_latency = integer("bus_latency");
  system.quantum = integer("quantum");
  return options;
}

bool gives_memory(const config::Settings& settings) {
  return std::ranges::any_of(config::parameters(), [&](const config::Parameter& parameter) {
    return parameter.part == config::Part::Memory && settings.entry(parameter.key).origin != "default";
  });
}

}  // namespace gnomon::cli
