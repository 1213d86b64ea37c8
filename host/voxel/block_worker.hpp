// SPDX-License-Identifier: Apache-2.0
// Runs the recursion within blocks. Theory: docs/voxelization.md, "Blocks".
#pragma once

#include <span>
#include <vector>

#include "host/surface/patch_tree.hpp"
#include "host/voxel/block.hpp"
#include "host/voxel/border_cache.hpp"
#include "host/voxel/completion.hpp"

namespace gnomon::voxel {

/// A leaf as it leaves a block: its corners are still voxels, not yet indices.
struct LeafRecord {
  std::uint32_t object, face;
  float u0, v0, u1, v1;
  Corners corners;
};

/// What is wanted of the blocks.
struct Wanted {
  bool representatives = false;
  bool leaves = false;
};

/// What came out of one or more blocks, in order.
struct BlockOutput {
  std::vector<VoxelKey> keys;  ///< voxels met, if no representatives are wanted; repetitions are possible
  std::vector<Voxel> voxels;   ///< or else with their representatives
  std::vector<LeafRecord> leaves;
  std::vector<VoxelKey> extra_keys;  ///< N = 6: voxels touched between the points, likewise
  std::vector<Voxel> extra_voxels;
  std::vector<BorderSide> sides;  ///< N = 6: sides of leaves that lie on a block's border
  VoxelStatistics statistics;
  double area = 0;
};

/// Scratch memory for one thread.
class BlockWorker {
 public:
  BlockWorker(std::span<const surface::LimitSurface> surfaces, std::span<BorderCache> borders,
              RecursionRules rules, Wanted wanted)
      : surfaces_(surfaces), borders_(borders), rules_(rules), wanted_(wanted) {}

  void run(const Block& block, BlockOutput& out);

 private:
  using Row = std::array<surface::Lane4, 4>;

  // A lattice cell, as its low and high corner; leaves are kept like this until the block is done.
  struct Box {
    int i0, j0, i1, j1;
  };

  void run_cell(Block block, BlockOutput& out);
  void run_children(const Block& block, BlockOutput& out);
  void run_lattice(const Block& block);
  void start(const Block& block);

  template <Adjacency kAdjacency>
  void recurse_all();
  template <Adjacency kAdjacency>
  void recurse(Box box, const Corners& corners);
  void keep_leaf(const Box& box) {
    ++leaf_count_;
    if (wanted_.leaves || rules_.adjacency == Adjacency::N6) leaves_.push_back(box);
  }

  template <Adjacency kAdjacency>
  VoxelKey at(int i, int j);
  template <Adjacency kAdjacency>
  VoxelKey foreign_voxel(int i, int j);
  template <Adjacency kAdjacency>
  VoxelKey keep(std::size_t index, const std::array<std::uint32_t, 4>& fixed);
  const Row& row(int j);
  bool own(int i, int j) const {
    return patch_ != nullptr && i >= own_u0_ && i <= own_u1_ && j >= own_v0_ && j <= own_v1_;
  }

  void collect(BlockOutput& out);
  Voxel representative(int i, int j);
  Vec3 unit_normal(int i, int j);
  void record_leaf(const Box& box, BlockOutput& out) const;

  void complete(const Box& box, BlockOutput& out);
  void complete_side(const Box& side, BlockOutput& out);
  void touch(const Triangle& triangle, int i, int j, BlockOutput& out);
  void record_side(const Box& side, BlockOutput& out);
  GridPoint point(int i, int j) const { return points_[lattice(i, j)]; }

  bool visited(int i, int j) const {
    return (visited_[static_cast<std::size_t>(j) * words_ + static_cast<std::size_t>(i >> 6)] >> (i & 63) &
            1) != 0;
  }
  std::size_t lattice(int i, int j) const {
    return static_cast<std::size_t>(j) * stride_ + static_cast<std::size_t>(i);
  }
  std::uint32_t u_at(int i) const {
    return block_.cell.u0 + (static_cast<std::uint32_t>(i) << (block_.cell.log_u - block_.cells_u));
  }
  std::uint32_t v_at(int j) const {
    return block_.cell.v0 + (static_cast<std::uint32_t>(j) << (block_.cell.log_v - block_.cells_v));
  }
  bool first_here(VoxelKey key);

  std::span<const surface::LimitSurface> surfaces_;
  std::span<BorderCache> borders_;
  RecursionRules rules_;
  Wanted wanted_;

  // The block at hand.
  Block block_;
  const surface::LimitSurface* surface_ = nullptr;
  const surface::Patch* patch_ = nullptr;  // null: points are asked for one by one
  int width_ = 0, height_ = 0;             // lattice cells
  std::size_t stride_ = 0, words_ = 0;
  int own_u0_ = 0, own_u1_ = 0, own_v0_ = 0, own_v1_ = 0;  // lattice points that the patch answers for
  double u_origin_ = 0, u_step_ = 0, v_origin_ = 0, v_step_ = 0, scale_ = 1;  // to the patch's own parameters
  bool grow_u_ = false, grow_v_ = false;
  std::uint64_t evaluations_ = 0, leaf_count_ = 0, floor_hits_ = 0, zero_normals_ = 0;

  std::vector<VoxelKey> keys_;
  std::vector<std::uint64_t> visited_;
  std::vector<GridPoint> points_;  // N = 6
  std::vector<Row> rows_, slopes_;
  std::vector<std::uint8_t> row_ready_, slope_ready_;
  std::vector<Box> leaves_;
  std::vector<Cell> coarse_;  // cells to be run on their own
  std::vector<VoxelKey> recent_;
};

}  // namespace gnomon::voxel
