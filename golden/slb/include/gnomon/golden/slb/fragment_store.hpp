// SPDX-License-Identifier: Apache-2.0
// The plane: entries with generation tags, chains put into them, groups finished by FILL (docs/slb.md,
// "Store").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/chain_builder.hpp>
#include <vector>

namespace gnomon::golden::slb {

class FragmentStore {
 public:
  explicit FragmentStore(const SlbConfig& config);

  /// Every entry empty, generation 1; as after reset.
  void reset();
  /// Every entry becomes empty by a new generation; scrubs its share of the plane.
  void clear();

  /// An entry as every reader sees it: stale ones are empty, generation 0.
  Entry read(int column, int row) const;

  /// What became of a chain.
  struct Insertion {
    bool dropped = false;  ///< the chain is not in the entry; its answer at the pixel's centre counts
    bool reduced = false;  ///< only the first line of its corner is
    bool evicted = false;  ///< a finished group had to go
  };
  /// `first`: the object's first chain in this pixel.
  Insertion insert(const Chain& chain, std::uint8_t object, bool first);

  /// What FILL made of a pixel with lines.
  struct Finish {
    bool covered = false;  ///< the object wholly covers the pixel
    bool rim = false;      ///< its lines stay
  };
  /// `keep_lines`: a wholly covered pixel keeps its lines (curved casters).
  Finish finish(int column, int row, int winding, bool keep_lines);

  /// In a pixel with a rim: whether a sheet that reaches from `front` to `depth` counts as full.
  bool is_full(int column, int row, std::uint32_t front, std::uint32_t depth, std::uint32_t margin) const;
  void lower_full_depth(int column, int row, std::uint32_t depth);

 private:
  /// An entry without its fragments.
  struct Head {
    std::uint8_t generation = 0;
    std::uint8_t count = 0;
    bool overflow = false, open = false;
    std::int8_t corner = 0;
    std::uint32_t full_depth = 0;
  };
  /// A row of the plane; nothing in it where nothing was ever written.
  struct Row {
    std::vector<Head> heads;
    std::vector<Fragment> fragments;  ///< K an entry
  };

  Row& allocated(int row);
  Entry load(int column, int row) const;
  void save(int column, int row, const Entry& entry);
  bool make_room(Entry& entry, std::uint32_t depth, bool& evicted) const;

  SlbConfig config_;
  std::uint8_t generation_ = 1;
  std::vector<Row> rows_;
};

}  // namespace gnomon::golden::slb
