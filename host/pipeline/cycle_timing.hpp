// SPDX-License-Identifier: Apache-2.0
// What the cycle model has to know of a simulated system.
#pragma once

#include <gnomon/golden/cycles.hpp>

#include "sim/system/system_engine.hpp"

namespace gnomon::pipeline {

/// Of the system around `options`' gnomon_top.
inline golden::HardwareTiming cycle_timing(const sim::system::SystemOptions& options) {
  const sim::system::DramConfig& dram = options.system.dram;
  return {.memory_latency = options.rtl.memory_latency,
          .slb_dividers = options.rtl.slb_dividers,
          .system = golden::SystemTiming{.cache_log2 = options.cache_log2,
                                         .line_ids_log2 = options.line_ids_log2,
                                         .axi_data_bits = options.axi_data_bits,
                                         .bus_latency = options.system.bus_latency,
                                         .latency = dram.latency,
                                         .banks = dram.banks,
                                         .row_bytes = dram.row_bytes,
                                         .rcd = dram.t_rcd,
                                         .rp = dram.t_rp,
                                         .cas = dram.t_cas,
                                         .bytes_per_cycle = dram.bytes_per_cycle,
                                         .dram_bytes = options.system.dram_bytes}};
}

}  // namespace gnomon::pipeline
