// SPDX-License-Identifier: Apache-2.0
// What the system needs of its hardware, whatever answers the commands inside.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <systemc>
#include <tlm>

#include "sim/system/event_log.hpp"

namespace gnomon::sim::system {

class HardwareBase : public sc_core::sc_module {
 public:
  virtual tlm::tlm_target_socket<>& register_side() = 0;
  virtual tlm::tlm_initiator_socket<>& memory_side() = 0;
  sc_core::sc_out<bool> interrupt;

  /// What was thrown inside: the simulation is paused, and the hardware does nothing any more.
  const std::exception_ptr& fault() const { return fault_; }
  /// Command words, since power-up.
  std::uint64_t words_taken() const { return words_taken_; }
  /// Told of every descriptor, if set.
  std::function<void(const DescriptorEvent&)> observe;

 protected:
  explicit HardwareBase(const sc_core::sc_module_name& name) : sc_module(name), interrupt("interrupt") {}

  /// For the exception being handled.
  void fail() {
    fault_ = std::current_exception();
    sc_core::sc_pause();
  }

  std::uint64_t words_taken_ = 0;

 private:
  std::exception_ptr fault_;
};

}  // namespace gnomon::sim::system
