// SPDX-License-Identifier: Apache-2.0
// Which points are to be confirmed on the hardware. Theory: docs/sweep.md, "Confirming".
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/sweep/store.hpp"

namespace gnomon::sweep {

class Selection {
 public:
  enum class Kind : std::uint8_t { None, Front, Some, All };

  /// "" (none), "front", "all", or how many.
  static Result<Selection> parse(const std::string& text);

  bool empty() const { return kind_ == Kind::None; }
  /// Keys of done points that are not confirmed yet: the front's of each scene, all, or as many as were asked
  /// for, spread evenly over the rows.
  std::set<std::string> choose(const std::vector<Row>& rows) const;

 private:
  Kind kind_ = Kind::None;
  std::size_t count_ = 0;  ///< of Some
};

}  // namespace gnomon::sweep
