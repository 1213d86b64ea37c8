// SPDX-License-Identifier: Apache-2.0
// The bus side of a block of registers: 32-bit accesses alone; others, and offsets without a register, are
// SLVERR.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <tlm>

namespace gnomon::sim::system {

/// `read(offset)` gives an optional, `write(offset, value)` whether it was taken.
template <class Read, class Write>
void transport_register(tlm::tlm_generic_payload& payload, Read read, Write write) {
  payload.set_response_status(tlm::TLM_GENERIC_ERROR_RESPONSE);
  if (payload.get_data_length() != 4) return;
  const auto offset = static_cast<std::uint32_t>(payload.get_address());
  std::uint32_t value = 0;
  if (payload.is_write()) {
    std::memcpy(&value, payload.get_data_ptr(), sizeof value);
    if (!write(offset, value)) return;
  } else {
    const std::optional<std::uint32_t> found = read(offset);
    if (!found) return;
    value = *found;
    std::memcpy(payload.get_data_ptr(), &value, sizeof value);
  }
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
}

}  // namespace gnomon::sim::system
