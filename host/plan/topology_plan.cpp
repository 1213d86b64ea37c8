// SPDX-License-Identifier: Apache-2.0
// Chooses lift and clearance, sizes the pools, orders the quads (docs/vpu-topology.md).
#include "host/plan/topology_plan.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gnomon/golden/topology/landing.hpp>
#include <numeric>
#include <utility>

namespace gnomon::plan {
namespace {

namespace topology = golden::topology;

/// Measured (docs/vpu-topology.md, "Choice of lift and clearance"); voxels, by fraction bits.
struct Choice {
  double lift, clearance;
};
constexpr std::array<Choice, 4> kChoices = {{{0.7, 2}, {0.35, 1.5}, {0.2, 1}, {0.1, 0.75}}};

constexpr double kCoarser = 1.25;  // from pitch to pitch, until the pool is large enough
constexpr double kLargestPitch = 16;
constexpr int kSmallestPool = 4;  // log2; what the hardware can be built with

int log2_at_least(std::uint64_t count) {
  return std::max(kSmallestPool, static_cast<int>(std::bit_width(std::max<std::uint64_t>(count, 1) - 1)));
}

VpuSettings projection_settings(const TopologySettings& settings) {
  VpuSettings vpu;
  vpu.pitch = settings.pitch;
  vpu.offset_factor = settings.lift >= 0 ? settings.lift : kChoices[0].lift;
  vpu.margin = 0;
  vpu.plane_log2 = settings.plane_log2;
  vpu.voxel_frac_bits = settings.voxel_frac_bits;
  vpu.normal_bits = settings.normal_bits;
  vpu.matrix_frac_bits = settings.matrix_frac_bits;
  vpu.depth_bits = settings.depth_bits;
  return vpu;
}

/// Every voxel as a corner, with the unit's own arithmetic.
std::vector<topology::Corner> land(const TopologyPlan& plan) {
  const topology::TopologyConfig config = plan.vpu.config.topology_config();
  const auto& m = plan.vpu.registers;
  std::vector<topology::Corner> corners(plan.items.size());
  std::transform(plan.items.begin(), plan.items.end(), corners.begin(), [&](const golden::VoxelItem& item) {
    const auto row = [&](std::size_t first) {
      return m[first] * item.position[0] + m[first + 1] * item.position[1] + m[first + 2] * item.position[2] +
             m[first + 3];
    };
    return topology::land_corner(topology::Projected{row(0), row(4), row(8)}, config);
  });
  return corners;
}

/// Farthest first: lists are pushed in front. Quads at the same depth keep their order.
void sort_by_far(std::vector<voxel::VoxelQuad>& quads, std::span<const topology::Corner> corners) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(quads.size());
  for (std::uint32_t i = 0; i < quads.size(); ++i) {
    std::uint32_t far = 0;
    for (const std::uint32_t c : quads[i]) far = std::max(far, corners[c].depth);
    order[i] = {~far, i};
  }
  tbb::parallel_sort(order.begin(), order.end());
  std::vector<voxel::VoxelQuad> sorted(quads.size());
  std::transform(order.begin(), order.end(), sorted.begin(), [&](const auto& o) { return quads[o.second]; });
  quads = std::move(sorted);
}

/// Counts the nodes of every entry, were the pool large enough.
std::uint64_t count_nodes(TopologyPlan& plan, std::span<const topology::Corner> corners) {
  const int sub_bits = plan.vpu.config.sub_bits;
  const std::int64_t last = plan.vpu.config.plane_side() - 1;
  plan.list_length.assign(static_cast<std::size_t>((last + 1) * (last + 1)), 0);
  std::uint64_t nodes = 0;
  for (const voxel::VoxelQuad& quad : plan.quads) {
    std::array<std::int64_t, 2> low{last + 1, last + 1}, high{-1, -1};
    for (const std::uint32_t c : quad) {
      const std::array at{corners[c].u >> sub_bits, corners[c].v >> sub_bits};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], std::max<std::int64_t>(at[axis], 0));
        high[axis] = std::max(high[axis], std::min(at[axis], last));
      }
    }
    for (std::int64_t v = low[1]; v <= high[1]; ++v) {
      for (std::int64_t u = low[0]; u <= high[0]; ++u) {
        ++plan.list_length[static_cast<std::size_t>(v * (last + 1) + u)];
        ++nodes;
      }
    }
  }
  return nodes;
}

}  // namespace

Result<TopologyPlan> plan_topology(const voxel::VoxelSet& voxels, std::span<const voxel::VoxelQuad> quads,
                                   const Vec3& light, const TopologySettings& settings) {
  if (!(light.length() > 0) || !std::isfinite(light.length()))
    return fail("light has no direction: expected three finite numbers, not all 0");
  return plan_topology(voxels, quads, directional_view(light), all_voxels(voxels), settings);
}

Result<TopologyPlan> plan_topology(const voxel::VoxelSet& voxels, std::span<const voxel::VoxelQuad> quads,
                                   const LightView& view, const ViewVoxels& seen,
                                   const TopologySettings& settings) {
  auto vpu = plan_vpu(voxels, view, seen, projection_settings(settings));
  if (!vpu) return tl::make_unexpected(vpu.error());
  const auto frac = static_cast<std::size_t>(vpu->config.voxel_frac_bits);
  const Choice& choice = kChoices[std::min(frac, kChoices.size() - 1)];
  TopologyPlan plan;
  plan.settings = settings;
  if (settings.lift < 0) {
    plan.settings.lift = choice.lift;
    vpu = plan_vpu(voxels, view, seen, projection_settings(plan.settings));
    if (!vpu) return tl::make_unexpected(vpu.error());
  }
  if (settings.clearance < 0) plan.settings.clearance = choice.clearance;
  plan.vpu = std::move(*vpu);
  golden::HardwareConfig& config = plan.vpu.config;
  config.en_vpu_topology = true;
  config.sub_bits = settings.sub_bits;
  config.span_log2 = settings.span_log2;
  const double codes = std::round(plan.settings.clearance * plan.vpu.projection.codes_per_voxel);
  plan.clearance =
      static_cast<std::uint32_t>(std::min(codes, static_cast<double>(config.topology_config().no_depth())));
  if (const auto wrong = config.check()) return fail(*wrong);

  plan.items = voxel_items(voxels, plan.vpu.config);
  plan.quads.assign(quads.begin(), quads.end());
  const auto corners = land(plan);
  if (settings.sorted) sort_by_far(plan.quads, corners);
  const std::uint64_t nodes = count_nodes(plan, corners);
  const double coarser_pitch = plan.vpu.settings.pitch * kCoarser;
  if (settings.nodes_log2 == 0 && log2_at_least(nodes) > settings.most_nodes_log2 &&
      coarser_pitch <= kLargestPitch) {
    TopologySettings coarser = settings;
    coarser.pitch = coarser_pitch;
    return plan_topology(voxels, quads, view, seen, coarser);
  }
  config.nodes_log2 = settings.nodes_log2 > 0 ? settings.nodes_log2 : log2_at_least(nodes);
  config.quads_log2 = settings.quads_log2 > 0 ? settings.quads_log2 : log2_at_least(quads.size());
  if (const auto wrong = config.check()) return fail(*wrong);
  plan.settings.pitch = plan.vpu.settings.pitch;
  plan.settings.plane_log2 = config.plane_log2;
  plan.settings.voxel_frac_bits = config.voxel_frac_bits;
  plan.settings.normal_bits = config.normal_bits;
  plan.settings.nodes_log2 = config.nodes_log2;
  plan.settings.quads_log2 = config.quads_log2;
  return plan;
}

}  // namespace gnomon::plan
