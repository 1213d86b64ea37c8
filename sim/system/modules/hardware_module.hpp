// SPDX-License-Identifier: Apache-2.0
// The hardware's front end: registers, descriptors, commands into an engine, results into memory
// (docs/system.md).
#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <systemc>
#include <vector>

#include "sim/system/device_registers.hpp"
#include "sim/system/modules/hardware_base.hpp"

namespace gnomon::sim::system {

class HardwareModule : public HardwareBase {
 public:
  /// The engine must outlive the module; it is reset with it. `clock` as in System.
  HardwareModule(const sc_core::sc_module_name& name, golden::Engine& engine,
                 std::function<std::uint64_t()> clock);

  tlm::tlm_target_socket<>& register_side() override { return registers_socket_; }
  tlm::tlm_initiator_socket<>& memory_side() override { return memory_socket_; }

 private:
  struct Descriptor {
    std::uint64_t address = 0;
    std::uint32_t words = 0;
    std::uint16_t job = 0, flags = 0;
  };
  struct Stopped {
    std::uint32_t code;
    std::uint64_t address;
  };
  struct Reset {};

  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  bool write(std::uint32_t offset, std::uint32_t value);
  void drive();
  void notify() { changed_.notify(sc_core::SC_ZERO_TIME); }

  void work();
  /// Waits for a descriptor and runs it.
  void serve();
  void idle();
  void check_rings() const;
  void run_descriptor();
  Descriptor fetch_descriptor(std::uint64_t place);
  void execute(const Descriptor& descriptor);
  void take(std::span<const golden::Word> words);
  void give_results();
  /// Cycles that the engine has worked since it was last asked; it has taken `words` meanwhile.
  std::uint64_t worked(std::uint64_t words);
  void deliver(std::span<const golden::Word> results);
  void complete(const Descriptor& descriptor, std::uint64_t place);
  void reset();

  /// Waits; a reset ends it by an exception.
  void pause(const sc_core::sc_time& time);
  void pause_until_changed();
  [[noreturn]] void wait_for_reset();
  /// What the transaction takes beyond now; stops the hardware if it is not answered well.
  sc_core::sc_time transfer(tlm::tlm_command command, std::uint64_t address, std::span<std::uint8_t> data);

  tlm_utils::simple_target_socket<HardwareModule> registers_socket_;
  tlm_utils::simple_initiator_socket<HardwareModule> memory_socket_;
  golden::Engine& engine_;
  std::function<std::uint64_t()> clock_;
  std::uint64_t clock_seen_ = 0;
  DeviceRegisters registers_;
  sc_core::sc_event changed_;  ///< registers, by software or by the hardware
  sc_core::sc_event wake_;     ///< software has changed something
  bool reset_requested_ = false;
  // The job under way.
  bool in_job_ = false;
  std::uint16_t job_ = 0xFFFF;
  std::uint32_t items_left_ = 0;  ///< of the command under way
  std::uint32_t errors_ = 0, flags_ = 0;
};

}  // namespace gnomon::sim::system
