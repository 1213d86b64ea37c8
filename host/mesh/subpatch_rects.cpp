// SPDX-License-Identifier: Apache-2.0
// The subpatches of a voxel set, object by object.
#include "host/mesh/subpatch_rects.hpp"

namespace gnomon::mesh {

std::vector<SubpatchRects> subpatch_rects(const voxel::VoxelSet& voxels, std::size_t objects) {
  std::vector<SubpatchRects> all(objects);
  for (std::uint32_t i = 0; i < voxels.subpatches.size(); ++i) {
    const voxel::Subpatch& p = voxels.subpatches[i];
    all.at(p.object).rects.push_back({p.face, p.u0, p.v0, p.u1, p.v1});
    all[p.object].subpatches.push_back(i);
  }
  return all;
}

}  // namespace gnomon::mesh
