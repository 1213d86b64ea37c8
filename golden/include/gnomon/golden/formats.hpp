// SPDX-License-Identifier: Apache-2.0
// Every number format of the projection unit, as docs/number-formats.md lists them.
#pragma once

#include <gnomon/golden/config.hpp>
#include <string>
#include <vector>

namespace gnomon::golden {

/// A value of the unit: the integer held in `width` bits is the value times 2^frac_bits.
struct ValueFormat {
  std::string name;  ///< as on the page
  int width = 0;     ///< bits, sign included
  bool is_signed = false;
  int frac_bits = 0;
  bool operator==(const ValueFormat&) const = default;
};

/// All values: registers, items, and every intermediate result, in the order of the page. No width
/// exceeds 64.
std::vector<ValueFormat> value_formats(const HardwareConfig& config);

}  // namespace gnomon::golden
