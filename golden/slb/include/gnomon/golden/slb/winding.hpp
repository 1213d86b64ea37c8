// SPDX-License-Identifier: Apache-2.0
// Winding numbers of the object being drawn (docs/slb.md, "Winding and FILL").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/config.hpp>
#include <span>
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
  struct Pixel {
    int winding = 0;     ///< W at its lower left corner
    bool lines = false;  ///< has_lines
  };
  /// The pixels of a row; clears what they are made from. Valid until the next call.
  std::span<const Pixel> take_row(int row);

  /// What FILL found out about a pixel, for COVER.
  struct Result {
    bool covered = false;  ///< the object wholly covers it
    bool rim = false;      ///< the entry's last group is the object's
  };
  void set_result(int column, int row, Result result);
  Result result(int column, int row) const;

 private:
  struct Cell {
    std::int16_t change = 0;  ///< dw, kept to kWindingMin..kWindingMax
    bool lines = false;
    Result result;
  };

  std::vector<Cell>& touch(int row);

  int side_;
  int first_, last_;
  std::vector<std::vector<Cell>> rows_;  ///< empty where nothing was ever drawn
  std::vector<std::int16_t> carry_;      ///< as dw
  std::vector<Pixel> taken_;
};

}  // namespace gnomon::golden::slb
