// SPDX-License-Identifier: Apache-2.0
// The bus: addresses to targets, its own latency, statistics, faults on demand.
#pragma once

#include <tlm_utils/multi_passthrough_initiator_socket.h>
#include <tlm_utils/multi_passthrough_target_socket.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tlm>
#include <vector>

#include "sim/system/event_log.hpp"

namespace gnomon::sim::system {

struct BusStatistics {
  std::string target;
  std::uint64_t reads = 0, writes = 0, bytes = 0;
};

class Router : public sc_core::sc_module {
 public:
  /// Initiators by the order in which they are bound.
  enum Initiator : int { kCpu = 0, kHardware = 1 };
  /// Another answer than the target's; nothing: the target answers. TLM_INCOMPLETE_RESPONSE: no answer.
  using Injector =
      std::function<std::optional<tlm::tlm_response_status>(int initiator, const tlm::tlm_generic_payload&)>;

  Router(const sc_core::sc_module_name& name, std::uint32_t latency_cycles);

  /// Targets in the order in which they are bound. Ranges must not overlap.
  void map(std::string target, std::uint64_t base, std::uint64_t bytes);

  tlm_utils::multi_passthrough_target_socket<Router> targets;
  tlm_utils::multi_passthrough_initiator_socket<Router> initiators;
  Injector inject;
  /// Told of every write of the hardware's that was answered well, with the cycle of the answer, if set.
  std::function<void(std::uint64_t address, std::uint32_t bytes, std::uint64_t cycle)> on_hardware_write;
  /// Told of every transaction, if set.
  std::function<void(const TransactionEvent&)> observe;
  const std::vector<BusStatistics>& statistics() const { return statistics_; }

 private:
  struct Range {
    std::uint64_t base, bytes;
  };
  void transport(int initiator, tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  /// The target that has answered.
  std::optional<std::size_t> forward(int initiator, tlm::tlm_generic_payload& payload,
                                     sc_core::sc_time& delay);
  std::optional<std::size_t> find(std::uint64_t address, std::uint64_t bytes) const;

  std::uint32_t latency_cycles_;
  std::vector<Range> ranges_;
  std::vector<BusStatistics> statistics_;
};

}  // namespace gnomon::sim::system
