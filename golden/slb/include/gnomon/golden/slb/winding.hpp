// SPDX-License-Identifier: Apache-2.0
// Winding numbers of the object being drawn (docs/slb.md, "Winding and FILL").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/config.hpp>
#include <vector>

namespace gnomon::golden::slb {

/// The scratch memory beside the plane: per pixel dw, has_lines and the result of FILL; per row a carry-in.
class Winding {
 public:
  explicit Winding(const SlbConfig& config);

  /// Everything zero; as after reset.
  void reset();
  /// A new object: no row is touched yet. dw and has_lines are zero already.
  void begin();
  /// An edge crosses y = row in this column. Returns false if a sum saturated.
  bool crossing(std::int64_t column, std::int64_t row, bool upwards);
  /// Marks a pixel of the plane; returns whether it was marked before.
  bool mark_lines(int column, int row);

  /// Touched rows first..last; empty if first > last.
  int first_row() const { return first_; }
  int last_row() const { return last_; }
  /// W at the lower left corner of each pixel of a row, and its has_lines bits; clears both.
  struct Row {
    std::vector<int> winding;
    std::vector<bool> lines;
  };
  Row take_row(int row);

  /// What FILL found out about a pixel, for COVER.
  struct Result {
    bool covered = false;  ///< the object wholly covers it
    bool rim = false;      ///< the entry's last group is the object's
  };
  void set_result(int column, int row, Result result);
  Result result(int column, int row) const;

 private:
  std::size_t index(int column, int row) const;
  void touch(int row);

  int side_;
  int first_, last_;
  std::vector<std::int16_t> change_, carry_;  ///< kept to kWindingMin..kWindingMax
  std::vector<bool> lines_;
  std::vector<Result> results_;
};

}  // namespace gnomon::golden::slb
