// SPDX-License-Identifier: Apache-2.0
// The Verilated gnomon_top on the bus: TLM on the outside, AXI signals within (docs/system-model.md).
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <optional>
#include <span>
#include <systemc>

#include "sim/system/modules/hardware_base.hpp"
#include "sim/top_model.hpp"

namespace gnomon::sim::system {

class TopModule : public HardwareBase {
 public:
  /// The model must outlive the module and be in reset state.
  TopModule(const sc_core::sc_module_name& name, TopModel& model);

  tlm::tlm_target_socket<>& register_side() override { return registers_; }
  tlm::tlm_initiator_socket<>& memory_side() override { return memory_; }

 private:
  void work();
  void drive() { interrupt.write(model_.interrupt()); }
  /// Runs the model until cycle `until`, or a little less.
  void advance(std::uint64_t until);
  /// What the master has asked for meanwhile.
  void serve();
  void serve(const GnomonTopRead& read);
  void serve(const GnomonTopWrite& write);
  void tell_descriptor(const GnomonTopRead& read, std::span<const std::uint8_t> data) const;

  struct Answer {
    std::uint64_t cycle = 0;
    std::optional<int> response;  ///< AXI's code; nothing: no answer at all
  };
  /// A transaction that begins at `cycle` of the model.
  Answer transfer(tlm::tlm_command command, std::uint64_t cycle, std::uint64_t address,
                  std::span<std::uint8_t> data);

  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  std::optional<std::uint32_t> end_access();

  tlm_utils::simple_target_socket<TopModule> registers_;
  tlm_utils::simple_initiator_socket<TopModule> memory_;
  TopModel& model_;
  sc_core::sc_event changed_;  ///< the interrupt line
};

}  // namespace gnomon::sim::system
