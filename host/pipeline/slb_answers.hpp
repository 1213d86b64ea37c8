// SPDX-License-Identifier: Apache-2.0
// What the silhouette-line buffer is asked in a run, and its answers.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/slb/query.hpp>
#include <span>
#include <vector>

#include "host/base/receiver.hpp"
#include "host/base/result.hpp"
#include "host/plan/light_view.hpp"
#include "host/plan/slb_plan.hpp"
#include "host/report/run_record.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// The representatives of the voxels that a directional light's view asks about, in their order.
std::vector<Receiver> voxel_receivers(std::span<const surface::LimitSurface> surfaces,
                                      const voxel::VoxelSet& voxels, const plan::ObjectRoles& roles,
                                      const plan::LightView& view, const plan::ViewVoxels& seen);

/// The answers among other results, in order; about `expected` of them. Fails where the hardware refused a
/// command.
Result<std::vector<golden::slb::QueryAnswer>> query_answers(std::span<const golden::Word> results,
                                                            std::size_t expected);

/// What the plane takes, its entries not looked at. `config`: the hardware that it is built into.
report::SlbRecord slb_record(const plan::SlbPlan& plan, const golden::HardwareConfig& config);

}  // namespace gnomon::pipeline
