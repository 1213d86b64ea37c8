// SPDX-License-Identifier: Apache-2.0
// DRAM: storage behind DramTiming.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <systemc>

#include "sim/system/dram_timing.hpp"

namespace gnomon::sim::system {

class DramModule : public sc_core::sc_module {
 public:
  DramModule(const sc_core::sc_module_name& name, std::uint64_t bytes, const DramConfig& config);

  tlm_utils::simple_target_socket<DramModule> socket;
  /// The content, without time.
  std::span<std::uint8_t> storage() { return {storage_.get(), bytes_}; }
  const DramStatistics& statistics() const { return timing_.statistics(); }

 private:
  struct Free {
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);

  std::uint64_t bytes_;
  std::unique_ptr<std::uint8_t, Free> storage_;
  DramTiming timing_;
};

}  // namespace gnomon::sim::system
