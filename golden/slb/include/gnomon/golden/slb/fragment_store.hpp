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
  std::size_t index(int column, int row) const;
  Entry load(std::size_t index) const;
  void save(std::size_t index, Entry entry);
  bool make_room(Entry& entry, std::uint32_t depth, bool& evicted) const;

  SlbConfig config_;
  std::uint8_t generation_ = 1;
  std::vector<Entry> entries_;
};

}  // namespace gnomon::golden::slb
