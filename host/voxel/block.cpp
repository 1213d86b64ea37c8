// SPDX-License-Identifier: Apache-2.0
// Cuts faces into blocks.
#include "host/voxel/block.hpp"

#include <algorithm>
#include <cmath>

#include "host/surface/patch_tree.hpp"

namespace gnomon::voxel {
namespace {

// Lattice steps are no longer than this many voxels, by the bound on the derivatives. Points half a voxel
// apart are always neighbours, and so are those across a cell's diagonal: the recursion never needs a finer
// lattice.
constexpr double kStep = 0.5;

// The largest lattice, log2 of its cells: its points stay in the second-level cache.
constexpr int kLargestBlock = 14;
// Cells across several pieces are slower per point; they are kept small unless the recursion wants them so.
constexpr int kLargestMixedBlock = 6;

int levels_for(double voxels) {
  return voxels <= kStep ? 0 : static_cast<int>(std::ceil(std::log2(voxels / kStep)));
}

}  // namespace

std::vector<Cell> Cell::children(Split split) const {
  std::vector<Cell> out;
  const Cell half{u0, v0, log_u - (split.u ? 1 : 0), log_v - (split.v ? 1 : 0)};
  for (std::uint32_t y = 0; y <= (split.v ? 1U : 0U); ++y) {
    for (std::uint32_t x = 0; x <= (split.u ? 1U : 0U); ++x) {
      out.push_back({u0 + (x << half.log_u), v0 + (y << half.log_v), half.log_u, half.log_v});
    }
  }
  return out;
}

RecursionRules RecursionRules::of(const Grid& grid) {
  // Around a vertex of high valence a cell's size shrinks by no less than 0.65 a level: so many levels bring
  // anything that fits into the grid below a voxel. Two more for good measure, and for N = 18 six more: where
  // a curve passes close to a voxel's corner, it changes three coordinates within a small part of a voxel.
  const int more = grid.adjacency == Adjacency::N18 ? 8 : 2;
  const int levels = static_cast<int>(std::ceil(std::log2(static_cast<double>(grid.res)) / 0.6)) + more;
  return {grid.adjacency, grid.res, kParameterBits - std::min(levels, kParameterBits)};
}

VoxelKey voxel_at(const surface::LimitSurface& surface, std::uint32_t face, std::uint32_t u, std::uint32_t v,
                  std::uint32_t res) {
  const Vec3 p = surface.position(face, parameter(u), parameter(v));
  return pack(snap(p.x, res) >> kFractionBits, snap(p.y, res) >> kFractionBits,
              snap(p.z, res) >> kFractionBits);
}

std::optional<Block> BlockSource::next() {
  while (true) {
    if (stack_.empty() && !next_face()) return std::nullopt;
    const Cell cell = stack_.back();
    stack_.pop_back();
    if (auto block = lattice_for(cell)) return block;
    // A cell that needs no division is a leaf, however large its lattice would be.
    if (!divide(cell)) return Block{object_, face_, cell, 0, 0};
  }
}

bool BlockSource::next_face() {
  while (object_ < surfaces_.size() && next_face_ == surfaces_[object_].face_count()) {
    ++object_;
    next_face_ = 0;
  }
  if (object_ == surfaces_.size()) return false;
  face_ = next_face_++;
  stack_.push_back({});
  memo_.start();
  return true;
}

std::optional<Block> BlockSource::lattice_for(const Cell& cell) const {
  const auto region = surfaces_[object_].pieces(face_).region(parameter(cell.u0), parameter(cell.v0),
                                                              parameter(cell.u1()), parameter(cell.v1()));
  const int u =
      std::min(levels_for(region.u_speed * parameter(1U << cell.log_u)), cell.log_u - rules_.smallest_log);
  const int v =
      std::min(levels_for(region.v_speed * parameter(1U << cell.log_v)), cell.log_v - rules_.smallest_log);
  if (u + v > (region.whole ? kLargestBlock : kLargestMixedBlock)) return std::nullopt;
  return Block{object_, face_, cell, u, v};
}

VoxelKey BlockSource::at(std::uint32_t u, std::uint32_t v) {
  if (const auto known = memo_.find(u, v)) return *known;
  ++evaluations_;
  const VoxelKey key = voxel_at(surfaces_[object_], face_, u, v, rules_.res);
  memo_.remember(u, v, key);
  return key;
}

bool BlockSource::divide(const Cell& cell) {
  Split split = rules_.split(
      {at(cell.u0, cell.v0), at(cell.u1(), cell.v0), at(cell.u1(), cell.v1()), at(cell.u0, cell.v1())},
      cell.log_u >= cell.log_v);
  split.u = split.u && cell.log_u > rules_.smallest_log;
  split.v = split.v && cell.log_v > rules_.smallest_log;
  if (split.none()) return false;
  auto children = cell.children(split);
  std::reverse(children.begin(), children.end());  // the last one pushed is the next one popped
  stack_.insert(stack_.end(), children.begin(), children.end());
  return true;
}

}  // namespace gnomon::voxel
