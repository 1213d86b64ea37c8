// SPDX-License-Identifier: Apache-2.0
// Runs the recursion within blocks. Theory: docs/voxelization.md, "Blocks".
#pragma once

#include <span>
#include <vector>

#include "host/voxel/block.hpp"
#include "host/voxel/brick_set.hpp"
#include "host/voxel/completion.hpp"
#include "host/voxel/lattice.hpp"

namespace gnomon::voxel {

/// A leaf as it leaves a block: its corners are still voxels, not yet indices.
struct LeafRecord {
  std::uint32_t object, face;
  float u0, v0, u1, v1;
  Corners corners;
};

/// A limit point outside the grid.
struct Outside {
  std::uint32_t object, face;
  double u, v;
};

/// What came out of one or more blocks, in order. Voxels may be repeated.
struct BlockOutput {
  std::vector<Voxel> voxels;
  std::vector<LeafRecord> leaves;  ///< if wanted
  std::vector<Voxel> extra;        ///< N = 6: voxels touched between the points
  std::vector<BorderSide> sides;   ///< N = 6: sides of leaves on a block's border
  std::optional<Outside> outside;  ///< the first such point: then nothing else counts
  VoxelStatistics statistics;
  double area = 0;
};

/// Scratch memory for one thread.
class BlockWorker {
 public:
  /// Where `members` is given, voxels go there, without representatives, instead of to the output.
  BlockWorker(std::span<const surface::LimitSurface> surfaces, std::span<BorderCache> borders,
              RecursionRules rules, bool leaves, BrickSet* members)
      : rules_(rules),
        leaves_wanted_(leaves),
        exact_(rules.adjacency == Adjacency::N6),
        members_(members),
        lattice_(surfaces, borders, rules.res, exact_) {}

  /// Begins a new sequence of blocks: what is evaluated again depends on the blocks since then alone.
  void begin() { lattice_.forget(); }
  void run(const Block& block, BlockOutput& out);

 private:
  // A cell of the lattice, as its low and high corner.
  struct Box {
    int i0, j0, i1, j1;
  };

  void run_cell(Block block, BlockOutput& out);
  void run_children(Block block, BlockOutput& out);
  void recurse_block();
  bool leaves_grid(BlockOutput& out) const;

  template <Adjacency kAdjacency>
  void recurse_all();
  template <Adjacency kAdjacency>
  void visit(const Box& box, const Corners& corners);
  template <Adjacency kAdjacency>
  void divide(const Box& box, const Corners& corners, Split split);
  void postpone(const Box& box, Split split);
  Split straighten(const Box& box);
  Vec3 position_at(int i, int j);
  Vec3 off_u(const Box& box, int j);
  Vec3 off_v(const Box& box, int i);
  void keep_leaf(const Box& box) {
    ++leaf_count_;
    if (leaves_wanted_ || exact_) leaves_.push_back(box);
  }
  int log_u(const Box& b) const {
    return block_.cell.log_u - block_.cells_u + std::countr_zero(static_cast<unsigned>(b.i1 - b.i0));
  }
  int log_v(const Box& b) const {
    return block_.cell.log_v - block_.cells_v + std::countr_zero(static_cast<unsigned>(b.j1 - b.j0));
  }

  void collect(BlockOutput& out);
  void record_leaf(const Box& box, BlockOutput& out) const;
  bool first_here(VoxelKey key);

  // N = 6.
  void complete(const Box& box, BlockOutput& out);
  void complete_side(const Box& side, BlockOutput& out);
  void touch(const Triangle& triangle, int i, int j, BlockOutput& out);
  void record_side(const Box& side, BlockOutput& out);
  Voxel voxel_at_point(int i, int j);

  RecursionRules rules_;
  bool leaves_wanted_;
  bool exact_;  // N = 6: positions are needed, not only voxels
  BrickSet* members_;
  Lattice lattice_;

  // The block at hand.
  Block block_;
  bool grow_u_ = false, grow_v_ = false;
  std::optional<Bend> bend_;
  std::uint64_t leaf_count_ = 0, floor_hits_ = 0, zero_normals_ = 0;
  std::vector<Box> leaves_;
  std::vector<Cell> coarse_;  // cells to be run on their own
  std::vector<VoxelKey> recent_;
};

}  // namespace gnomon::voxel
