// SPDX-License-Identifier: Apache-2.0
// Outlines, surface samples and receivers as commands of the silhouette-line buffer (docs/planning.md).
#pragma once

#include <gnomon/golden/stream.hpp>
#include <span>
#include <vector>

#include "host/base/receiver.hpp"
#include "host/outline/outline.hpp"
#include "host/plan/item_order.hpp"
#include "host/plan/slb_plan.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// A point of a sheet that faces the light, with the sheet's slope there.
struct SheetSample {
  Vec3 point, normal;
};

/// Samples of one object's sheets that face the light (all sheets, if two-sided), close enough together that
/// every pixel wholly inside a sheet has one. `voxels` needs subpatches.
std::vector<SheetSample> sheet_samples(const SlbPlan& plan, const surface::LimitSurface& surface,
                                       const voxel::VoxelSet& voxels, std::uint32_t object, bool two_sided);

/// What COVER says of them: one sample for each sheet in each pixel, farthest first. Depends on the plane and
/// the depth's bits alone.
std::vector<golden::slb::CoverSample> cover_samples(const SlbPlan& plan,
                                                    std::span<const SheetSample> samples);

/// Clears the plane and draws one object after the other. `outlines` and `sheets` run as the casters among
/// the objects, in order.
void draw_casters(golden::StreamWriter& writer, const SlbPlan& plan,
                  std::span<const outline::ObjectOutline> outlines,
                  std::span<const std::vector<golden::slb::CoverSample>> sheets);

/// The order in which receivers are to be asked about: receivers[places[i]] comes i-th. Empty for their own.
std::vector<std::uint32_t> asking_order(const SlbPlan& plan, std::span<const Receiver> receivers,
                                        ItemOrder order);
/// One query for each receiver that faces the light; `places` as above.
void ask_receivers(golden::StreamWriter& writer, const SlbPlan& plan, std::span<const Receiver> receivers,
                   std::span<const std::uint32_t> places = {});

}  // namespace gnomon::plan
