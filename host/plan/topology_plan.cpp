// SPDX-License-Identifier: Apache-2.0
// Chooses lift and clearance, sizes the pools, orders the quads (docs/vpu-topology.md).
#include "host/plan/topology_plan.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <gnomon/golden/perspective/view.hpp>
#include <gnomon/golden/topology/landing.hpp>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "host/plan/quad_order.hpp"
#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

namespace topology = golden::topology;

/// Measured (docs/vpu-topology.md, "Choice of lift and clearance"); voxels, by fraction bits.
struct Choice {
  double lift, clearance;
};
constexpr std::array<Choice, 5> kChoices = {{{0.7, 2}, {0.35, 1.5}, {0.2, 1}, {0.1, 0.75}, {0.08, 0.75}}};

/// Quads may cover many entries, but not more than a record holds: three voxels in 2^6 - 1 entries.
constexpr double kCasterPitch = 3.0 / 63;
constexpr double kCoarser = 1.25;  // from pitch to pitch, until the pool is large enough
constexpr double kLargestPitch = 16;
constexpr int kSmallestPool = 4;  // log2; what the hardware can be built with

int log2_at_least(std::uint64_t count) {
  return std::max(kSmallestPool, static_cast<int>(std::bit_width(std::max<std::uint64_t>(count, 1) - 1)));
}

VpuSettings projection_settings(const TopologySettings& settings) {
  VpuSettings vpu;
  vpu.pitch = settings.pitch;
  vpu.caster_pitch = kCasterPitch;
  vpu.offset_factor = settings.lift >= 0 ? settings.lift : kChoices[0].lift;
  vpu.margin = 0;
  vpu.plane_log2 = settings.plane_log2;
  vpu.voxel_frac_bits = settings.voxel_frac_bits;
  vpu.normal_bits = settings.normal_bits;
  vpu.matrix_frac_bits = settings.matrix_frac_bits;
  vpu.depth_bits = settings.depth_bits;
  return vpu;
}

/// A voxel as a corner; nothing where it is behind the light.
using Landing = std::optional<topology::Corner>;

golden::perspective::Registers perspective_registers(const VpuPlan& plan) {
  const auto& m = plan.registers;
  const auto at = [&](golden::Register reg) { return m.at(static_cast<std::size_t>(reg)); };
  golden::perspective::Registers registers;
  registers.perspective = true;
  for (std::size_t i = 0; i < 4; ++i)
    registers.w[i] = m.at(static_cast<std::size_t>(golden::Register::MatrixWx) + i);
  registers.w_near = at(golden::Register::WNear);
  registers.centre = {at(golden::Register::CentreU), at(golden::Register::CentreV)};
  registers.key_limit = at(golden::Register::KeyLimit);
  registers.key_scale = at(golden::Register::KeyScale);
  return registers;
}

/// Every voxel as a corner, with the unit's own arithmetic.
std::vector<Landing> land(const TopologyPlan& plan) {
  const golden::HardwareConfig& hardware = plan.vpu.config;
  const topology::TopologyConfig config = hardware.topology_config();
  const auto& m = plan.vpu.registers;
  const bool perspective = plan.vpu.projection.perspective;
  const golden::perspective::View view(
      {hardware.position_bits(), hardware.matrix_frac_bits, hardware.depth_bits, hardware.plane_log2},
      perspective ? perspective_registers(plan.vpu) : golden::perspective::Registers{});
  const auto landing = [&](const golden::VoxelItem& item) -> Landing {
    const auto row = [&](std::size_t first) {
      return m[first] * item.position[0] + m[first + 1] * item.position[1] + m[first + 2] * item.position[2] +
             m[first + 3];
    };
    if (!perspective) return topology::land_corner(topology::Projected{row(0), row(4), row(8)}, config);
    const golden::perspective::Sight sight = view.see(row(0), row(4), item.position);
    if (sight.behind) return std::nullopt;
    return topology::land_corner(sight, config);
  };
  std::vector<Landing> corners(plan.items.size());
  std::transform(plan.items.begin(), plan.items.end(), corners.begin(), landing);
  return corners;
}

/// Farthest first: lists are pushed in front. Quads at the same depth keep their order; those with a corner
/// behind the light, which cast nothing, come first of all.
void sort_by_far(std::vector<voxel::VoxelQuad>& quads, std::span<const Landing> corners) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> order(quads.size());
  for (std::uint32_t i = 0; i < quads.size(); ++i) {
    std::uint32_t far = 0;
    for (const std::uint32_t c : quads[i])
      far = std::max(far, corners[c] ? corners[c]->depth : std::numeric_limits<std::uint32_t>::max());
    order[i] = {~far, i};
  }
  tbb::parallel_sort(order.begin(), order.end());
  std::vector<voxel::VoxelQuad> sorted(quads.size());
  std::transform(order.begin(), order.end(), sorted.begin(), [&](const auto& o) { return quads[o.second]; });
  quads = std::move(sorted);
}

/// The entries of a quad's box; empty (low above high) where the quad casts nothing or misses the plane.
struct Box {
  std::array<std::int64_t, 2> low{}, high{};
  std::int64_t span = 0;  ///< entries of the longer side, before clipping
};
std::optional<Box> box_of(const voxel::VoxelQuad& quad, std::span<const Landing> corners, int sub_bits,
                          std::int64_t last) {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  Box box{{kFar, kFar}, {-kFar, -kFar}, 0};
  for (const std::uint32_t c : quad) {
    if (!corners[c]) return std::nullopt;
    const std::array at{corners[c]->u >> sub_bits, corners[c]->v >> sub_bits};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], at[axis]);
      box.high[axis] = std::max(box.high[axis], at[axis]);
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    box.span = std::max(box.span, box.high[axis] - box.low[axis] + 1);
    box.low[axis] = std::max<std::int64_t>(box.low[axis], 0);
    box.high[axis] = std::min(box.high[axis], last);
    if (box.low[axis] > box.high[axis]) return std::nullopt;
  }
  return box;
}

/// A directional light's quads fit any legal span; near a light they may take more.
int span_for(const TopologyPlan& plan, std::span<const Landing> corners) {
  constexpr int kLargestSpan = 6;
  const golden::HardwareConfig& config = plan.vpu.config;
  if (!plan.vpu.projection.perspective) return config.span_log2;
  std::int64_t longest = 0;
  for (const voxel::VoxelQuad& quad : plan.quads) {
    const auto box = box_of(quad, corners, config.sub_bits, config.plane_side() - 1);
    if (box) longest = std::max(longest, box->span);
  }
  const int needed =
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(longest, 1) - 1)));
  return std::clamp(needed, config.span_log2, std::max(kLargestSpan, config.span_log2));
}

/// Counts the nodes of every entry, were the pool large enough.
std::uint64_t count_nodes(TopologyPlan& plan, std::span<const Landing> corners) {
  const golden::HardwareConfig& config = plan.vpu.config;
  const std::int64_t side = config.plane_side();
  plan.list_length.assign(static_cast<std::size_t>(side * side), 0);
  std::uint64_t nodes = 0;
  for (const voxel::VoxelQuad& quad : plan.quads) {
    const auto box = box_of(quad, corners, config.sub_bits, side - 1);
    if (!box || box->span > std::int64_t{1} << config.span_log2) continue;
    for (std::int64_t v = box->low[1]; v <= box->high[1]; ++v) {
      for (std::int64_t u = box->low[0]; u <= box->high[0]; ++u) {
        ++plan.list_length[static_cast<std::size_t>(v * side + u)];
        ++nodes;
      }
    }
  }
  return nodes;
}

/// So that the plane is visited near by near, and every list stays as it is.
void order_by_place(TopologyPlan& plan, std::span<const Landing> corners) {
  const golden::HardwareConfig& config = plan.vpu.config;
  const std::int64_t side = config.plane_side();
  std::vector<LinkedBox> boxes(plan.quads.size());
  std::ranges::transform(plan.quads, boxes.begin(), [&](const voxel::VoxelQuad& quad) {
    const auto box = box_of(quad, corners, config.sub_bits, side - 1);
    if (!box || box->span > std::int64_t{1} << config.span_log2) return LinkedBox{};
    const auto entries = [](std::int64_t count) { return static_cast<std::uint32_t>(count); };
    return LinkedBox{entries(box->low[0]), entries(box->low[1]), entries(box->high[0] - box->low[0] + 1),
                     entries(box->high[1] - box->low[1] + 1)};
  });
  std::vector<voxel::VoxelQuad> ordered(plan.quads.size());
  std::ranges::transform(depth_first(boxes, static_cast<std::uint32_t>(side)), ordered.begin(),
                         [&](std::uint32_t i) { return plan.quads[i]; });
  plan.quads = std::move(ordered);
}

/// Whether the plane sees an area of it: edge-on to the light no beam meets it (docs/vpu-topology.md,
/// "Casters"). Of what the unit drops or flags by itself nothing is decided here.
bool has_area(const voxel::VoxelQuad& quad, std::span<const Landing> corners, const Box& box, int span_log2) {
  if (box.span > std::int64_t{1} << span_log2) return true;
  const auto at = [&](std::size_t i) {
    return std::array{corners[quad[i]]->u - corners[quad[0]]->u, corners[quad[i]]->v - corners[quad[0]]->v};
  };
  const auto b = at(1), c = at(2), d = at(3);
  return b[0] * c[1] != b[1] * c[0] || c[0] * d[1] != c[1] * d[0];
}

/// Leaves out the quads that are edge-on to the light; returns how many.
std::uint64_t drop_edge_on(TopologyPlan& plan, std::span<const Landing> corners) {
  const golden::HardwareConfig& config = plan.vpu.config;
  return std::erase_if(plan.quads, [&](const voxel::VoxelQuad& quad) {
    const auto box = box_of(quad, corners, config.sub_bits, config.plane_side() - 1);
    return box && !has_area(quad, corners, *box, config.span_log2);
  });
}

/// Those with a corner that can shadow something of the view.
std::vector<voxel::VoxelQuad> quads_in_view(const voxel::VoxelSet& voxels, const LightView& view,
                                            std::span<const voxel::VoxelQuad> quads) {
  if (!view.perspective()) return {quads.begin(), quads.end()};
  std::vector<bool> near(voxels.voxels.size());
  for (std::size_t i = 0; i < near.size(); ++i) near[i] = view.can_shadow(representative(voxels.voxels[i]));
  std::vector<voxel::VoxelQuad> some;
  std::ranges::copy_if(quads, std::back_inserter(some), [&](const voxel::VoxelQuad& quad) {
    return std::ranges::any_of(quad, [&](std::uint32_t corner) { return near[corner]; });
  });
  return some;
}

/// In depth codes, or, in perspective, in units of w (docs/vpu-topology.md).
std::uint32_t clearance_of(const TopologyPlan& plan) {
  const golden::HardwareConfig& config = plan.vpu.config;
  const Projection& p = plan.vpu.projection;
  const double clearance = plan.settings.clearance;
  if (!p.perspective) {
    const double codes = std::round(clearance * p.codes_per_voxel);
    return static_cast<std::uint32_t>(
        std::min(codes, static_cast<double>(config.topology_config().no_depth())));
  }
  constexpr int kFracBits = 12;
  const double most = std::ldexp(1.0, golden::perspective::kClearanceBits) - 1;
  return static_cast<std::uint32_t>(
      std::min(std::round(std::ldexp(clearance / p.w_scale, config.position_bits() + kFracBits)), most));
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
  plan.clearance = clearance_of(plan);
  if (const auto wrong = config.check()) return fail(*wrong);

  plan.items = voxel_items(voxels, plan.vpu.config);
  plan.quads = quads_in_view(voxels, view, quads);
  const auto corners = land(plan);
  config.span_log2 = span_for(plan, corners);
  plan.edge_on = drop_edge_on(plan, corners);
  if (settings.sorted) sort_by_far(plan.quads, corners);
  if (settings.order == ItemOrder::Tile) order_by_place(plan, corners);
  const std::uint64_t nodes = count_nodes(plan, corners);
  const double coarser_pitch = plan.vpu.settings.pitch * kCoarser;
  if (settings.nodes_log2 == 0 && log2_at_least(nodes) > settings.most_nodes_log2 &&
      coarser_pitch <= kLargestPitch) {
    TopologySettings coarser = settings;
    coarser.pitch = coarser_pitch;
    return plan_topology(voxels, quads, view, seen, coarser);
  }
  config.nodes_log2 = settings.nodes_log2 > 0 ? settings.nodes_log2 : log2_at_least(nodes);
  config.quads_log2 = settings.quads_log2 > 0 ? settings.quads_log2 : log2_at_least(plan.quads.size());
  if (const auto wrong = config.check()) return fail(*wrong);
  plan.settings.pitch = plan.vpu.settings.pitch;
  plan.settings.plane_log2 = config.plane_log2;
  plan.settings.voxel_frac_bits = config.voxel_frac_bits;
  plan.settings.normal_bits = config.normal_bits;
  plan.settings.nodes_log2 = config.nodes_log2;
  plan.settings.span_log2 = config.span_log2;
  plan.settings.quads_log2 = config.quads_log2;
  return plan;
}

}  // namespace gnomon::plan
