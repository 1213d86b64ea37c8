// SPDX-License-Identifier: Apache-2.0
// Copies, and asks when it is done.
#include "sim/system/modules/dram_module.hpp"

#include <cstring>
#include <new>

#include "sim/system/modules/clock.hpp"

namespace gnomon::sim::system {

// calloc, because pages that nobody touches cost nothing.
DramModule::DramModule(const sc_core::sc_module_name& name, std::uint64_t bytes, const DramConfig& config)
    : sc_module(name),
      socket("socket"),
      bytes_(bytes),
      storage_(static_cast<std::uint8_t*>(std::calloc(bytes, 1))),
      timing_(config) {
  if (storage_ == nullptr) throw std::bad_alloc();
  socket.register_b_transport(this, &DramModule::transport);
}

/// The router has checked the range.
void DramModule::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  const std::uint64_t address = payload.get_address();
  const std::uint32_t length = payload.get_data_length();
  std::uint8_t* const at = storage_.get() + address;
  if (payload.is_write())
    std::memcpy(at, payload.get_data_ptr(), length);
  else
    std::memcpy(payload.get_data_ptr(), at, length);
  const std::uint64_t now = to_cycles(sc_core::sc_time_stamp() + delay);
  delay = cycles(timing_.access(now, address, length, payload.is_write())) - sc_core::sc_time_stamp();
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
}

}  // namespace gnomon::sim::system
