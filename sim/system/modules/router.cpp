// SPDX-License-Identifier: Apache-2.0
// Decoding and forwarding.
#include "sim/system/modules/router.hpp"

#include <utility>

#include "sim/system/modules/clock.hpp"

namespace gnomon::sim::system {
namespace {

std::string_view answer_name(tlm::tlm_response_status status) {
  switch (status) {
    case tlm::TLM_OK_RESPONSE:
      return "okay";
    case tlm::TLM_ADDRESS_ERROR_RESPONSE:
      return "decerr";
    case tlm::TLM_INCOMPLETE_RESPONSE:
      return "none";
    default:
      return "slverr";
  }
}

}  // namespace

Router::Router(const sc_core::sc_module_name& name, std::uint32_t latency_cycles)
    : sc_module(name), targets("targets"), initiators("initiators"), latency_cycles_(latency_cycles) {
  targets.register_b_transport(this, &Router::transport);
}

void Router::map(std::string target, std::uint64_t base, std::uint64_t bytes) {
  ranges_.push_back({base, bytes});
  statistics_.push_back({std::move(target)});
}

std::optional<std::size_t> Router::find(std::uint64_t address, std::uint64_t bytes) const {
  for (std::size_t i = 0; i < ranges_.size(); ++i)
    if (address >= ranges_[i].base && bytes <= ranges_[i].bytes &&
        address - ranges_[i].base <= ranges_[i].bytes - bytes)
      return i;
  return std::nullopt;
}

/// A target sees offsets from its base.
std::optional<std::size_t> Router::forward(int initiator, tlm::tlm_generic_payload& payload,
                                           sc_core::sc_time& delay) {
  if (inject) {
    if (const auto answer = inject(initiator, payload)) {
      payload.set_response_status(*answer);
      return std::nullopt;
    }
  }
  const std::uint64_t address = payload.get_address();
  const std::optional<std::size_t> target = find(address, payload.get_data_length());
  if (!target) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return std::nullopt;
  }
  BusStatistics& statistics = statistics_[*target];
  (payload.is_write() ? statistics.writes : statistics.reads) += 1;
  statistics.bytes += payload.get_data_length();
  payload.set_address(address - ranges_[*target].base);
  initiators[static_cast<int>(*target)]->b_transport(payload, delay);
  payload.set_address(address);
  return target;
}

void Router::transport(int initiator, tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  const std::uint64_t begin = to_cycles(sc_core::sc_time_stamp() + delay);
  delay += cycles(latency_cycles_);
  const std::optional<std::size_t> target = forward(initiator, payload, delay);
  const std::uint64_t end = to_cycles(sc_core::sc_time_stamp() + delay);
  if (initiator == kHardware && payload.is_write() && payload.is_response_ok() && on_hardware_write)
    on_hardware_write(payload.get_address(), payload.get_data_length(), end);
  if (!observe) return;
  observe({.begin = begin,
           .end = end,
           .initiator = initiator == kCpu ? "cpu" : "hardware",
           .target = target ? std::string_view(statistics_[*target].target) : "none",
           .write = payload.is_write(),
           .address = payload.get_address(),
           .bytes = payload.get_data_length(),
           .answer = answer_name(payload.get_response_status())});
}

}  // namespace gnomon::sim::system
