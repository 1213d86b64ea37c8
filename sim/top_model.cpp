// SPDX-License-Identifier: Apache-2.0
// What of it can fail.
#include "sim/top_model.hpp"

#include <stdexcept>

#include "sim/rtl_engine.hpp"

namespace gnomon::sim {

int TopModel::run(std::uint64_t until) {
  const int events = api_.run(model_.get(), until);
  if ((events & GNOMON_TOP_FAULT) == 0) return events;
  throw RtlFault("the RTL stopped at cycle " + std::to_string(cycle()) + ": " + api_.fault(model_.get()));
}

void TopModel::open_trace(const std::filesystem::path& file, std::uint64_t from, std::uint64_t to) {
  if (!api_.trace_open(model_.get(), file.c_str(), from, to))
    throw std::runtime_error("cannot write a waveform to " + file.string());
}

}  // namespace gnomon::sim
