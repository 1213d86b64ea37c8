// SPDX-License-Identifier: Apache-2.0
// The golden buffer with outlines drawn into it.
#pragma once

#include <gnomon/golden/slb/model.hpp>
#include <vector>

#include "host/outline/outline.hpp"

namespace gnomon::bench {

/// One flat caster; 2^frac_bits times finer than its plane of 2^plane_log2 pixels a side; queries have 16
/// fraction bits.
class Buffer {
 public:
  Buffer(int plane_log2, int frac_bits, const std::vector<outline::Loop>& loops);
  bool shadow(std::int64_t x, std::int64_t y) { return model_.query({x, y, 1}, 0).shadow; }
  const golden::slb::SlbCounters& counters() const { return model_.counters(); }

 private:
  golden::slb::SlbModel model_;
};

}  // namespace gnomon::bench
