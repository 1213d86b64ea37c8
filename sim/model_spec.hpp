// SPDX-License-Identifier: Apache-2.0
// Which model of the hardware is wanted.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <string>
#include <vector>

namespace gnomon::sim {

/// Which module is the model's top.
enum class ModelTop : std::uint8_t {
  Core,  ///< gnomon_core: the units with their streams
  Bus,   ///< gnomon_top: the same behind registers and a bus
};

/// Everything that decides what a compiled model does, besides the RTL itself.
struct ModelSpec {
  golden::HardwareConfig config{};
  ModelTop top = ModelTop::Core;
  bool trace = false;       ///< can write waveforms; no slower while it writes none
  bool coverage = false;    ///< counts lines and toggles
  bool assertions = false;  ///< the RTL's assertions stop the model
  /// Without Verilator's rewriting of bit operations (-fno-const-bit-op-tree), a source of wrong code in some
  /// of its versions: for the test that both give the same answers.
  bool plain_bit_operations = false;
  /// Compiled with less optimisation, in little more than half the time: for a run too short to make up for
  /// it.
  bool quick_build = false;
  int memory_latency = 1;     ///< MEM_LATENCY: cycles of a read of the plane's memory
  int memory_stall_seed = 0;  ///< MEM_STALL_SEED, 0..65535: other than 0, the plane's ports stall at random
  int slb_dividers = 2;       ///< SLB_DIVIDERS, 1..3: quotients a cycle; only with EN_SLB
  int cache_log2 = 0;         ///< CACHE_LOG2, 0 or 12..16: bytes of each unit's cache; only with the bus
  int line_ids_log2 = 4;      ///< LINE_IDS_LOG2, 3..5: of lines under way each way; only with a cache
  int axi_data_bits = 64;     ///< AXI_DATA_BITS, 64..512; only with the bus
  std::vector<std::string> defines{};  ///< preprocessor names, e.g. a GNOMON_MUTATE_* fault

  bool operator==(const ModelSpec&) const = default;
};

/// "VOXEL_BITS=8 VOXEL_FRAC_BITS=2 ...", every parameter; those of the silhouette-line buffer only where it
/// is built.
std::string describe(const golden::HardwareConfig& config);
/// The same, and whatever else is special about the model.
std::string describe(const ModelSpec& spec);

/// "gnomon_core" or "gnomon_top".
const char* module_name(ModelTop top);

/// Verilator's arguments for the spec: parameters, defines and instrumentation.
std::vector<std::string> verilator_arguments(const ModelSpec& spec);

}  // namespace gnomon::sim
