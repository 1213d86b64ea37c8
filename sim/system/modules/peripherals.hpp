// SPDX-License-Identifier: Apache-2.0
// Mailbox and timer (docs/registers.md).
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <functional>
#include <systemc>

#include "sim/registers/register_file.hpp"

namespace gnomon::sim::system {

class MailboxModule : public sc_core::sc_module {
 public:
  explicit MailboxModule(const sc_core::sc_module_name& name);

  tlm_utils::simple_target_socket<MailboxModule> socket;
  sc_core::sc_out<bool> doorbell;
  /// Called after each write of the firmware's.
  std::function<void(std::uint32_t offset, std::uint32_t value)> on_write;

  /// The host's side.
  std::uint32_t get(std::uint32_t offset) const { return file_.get(offset); }
  void set(std::uint32_t offset, std::uint32_t value) { file_.set(offset, value); }
  void ring();

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  bool write(std::uint32_t offset, std::uint32_t value);
  void drive();

  registers::RegisterFile file_;
  sc_core::sc_event changed_;
};

class TimerModule : public sc_core::sc_module {
 public:
  explicit TimerModule(const sc_core::sc_module_name& name);

  tlm_utils::simple_target_socket<TimerModule> socket;
  sc_core::sc_out<bool> expired;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  std::optional<std::uint32_t> read(std::uint32_t offset);
  bool write(std::uint32_t offset, std::uint32_t value);
  void drive();

  registers::RegisterFile file_;
  sc_core::sc_event changed_;
};

}  // namespace gnomon::sim::system
