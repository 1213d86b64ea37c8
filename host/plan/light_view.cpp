// SPDX-License-Identifier: Apache-2.0
// Lights as the projections that the hardware makes (docs/planning.md, "Views").
#include "host/plan/light_view.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

constexpr std::array<const char*, 6> kSideNames{"+x", "-x", "+y", "-y", "+z", "-z"};

constexpr double kGuard = 4;     // voxels around what a view answers: offset points, corners of quads
constexpr double kSlant = 1.05;  // the same far from the light, where entries are large

LightView spot_view(const SpotLight& light) {
  LightView view;
  view.kind = LightView::Kind::Spot;
  view.axes = light_axes(light.direction);
  view.eye = light.position;
  view.tangent = std::tan(light.half_angle * std::numbers::pi / 180);
  return view;
}

LightView side_view(const PointLight& light, int half_axis) {
  LightView view;
  view.kind = LightView::Kind::PointSide;
  Vec3 way(0, 0, 0);
  way[half_axis / 2] = half_axis % 2 == 0 ? 1 : -1;
  view.axes = light_axes(way);
  view.eye = light.position;
  view.tangent = 1;
  view.half_axis = half_axis;
  return view;
}

std::vector<LightView> point_views(const PointLight& light, const voxel::VoxelSet& voxels) {
  std::array<bool, 6> used{};
  for (const voxel::Voxel& voxel : voxels.voxels)
    used.at(static_cast<std::size_t>(half_axis_of(representative(voxel) - light.position))) = true;
  std::vector<LightView> views;
  for (int side = 0; side < 6; ++side)
    if (used.at(static_cast<std::size_t>(side))) views.push_back(side_view(light, side));
  return views;
}

}  // namespace

bool LightView::answers(const Vec3& p) const {
  switch (kind) {
    case Kind::Directional:
      return true;
    case Kind::PointSide:
      return half_axis_of(p - eye) == half_axis;
    case Kind::Spot:
      break;
  }
  const Vec3 from = p - eye;
  const double along = axes.away.dot(from);
  return along > 0 && (from - axes.away * along).length() <= tangent * along;
}

bool LightView::can_shadow(const Vec3& p) const {
  if (kind == Kind::Directional) return true;
  const Vec3 from = p - eye;
  const double along = axes.away.dot(from);
  if (along < -kGuard) return false;
  const double reach = std::max(along, 0.0) * tangent * kSlant + kGuard;
  if (kind == Kind::Spot) return (from - axes.away * along).length() <= reach;
  return std::abs(axes.right.dot(from)) <= reach && std::abs(axes.up.dot(from)) <= reach;
}

std::string LightView::name() const {
  if (kind == Kind::PointSide) return kSideNames.at(static_cast<std::size_t>(half_axis));
  return kind == Kind::Spot ? "spot" : "directional";
}

int half_axis_of(const Vec3& from_light) {
  int along = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(from_light[axis]) > std::abs(from_light[along])) along = axis;
  return 2 * along + (from_light[along] < 0 ? 1 : 0);
}

LightView directional_view(const Vec3& travel) {
  LightView view;
  view.axes = light_axes(travel);
  return view;
}

std::vector<LightView> light_views(const Light& light, const voxel::VoxelSet& voxels) {
  if (const auto* directional = std::get_if<DirectionalLight>(&light))
    return {directional_view(directional->direction)};
  if (const auto* spot = std::get_if<SpotLight>(&light)) return {spot_view(*spot)};
  return point_views(std::get<PointLight>(light), voxels);
}

ViewVoxels all_voxels(const voxel::VoxelSet& voxels) {
  std::vector<std::uint32_t> numbers(voxels.voxels.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return {numbers, numbers};
}

ObjectRoles ObjectRoles::all(std::vector<bool> two_sided) {
  const std::size_t objects = two_sided.size();
  return {std::vector<bool>(objects, true), std::vector<bool>(objects, true), std::move(two_sided)};
}

ViewVoxels view_voxels(const LightView& view, const voxel::VoxelSet& voxels, const ObjectRoles& roles) {
  ViewVoxels numbers;
  numbers.casters.reserve(voxels.voxels.size());
  numbers.receivers.reserve(voxels.voxels.size());
  for (std::uint32_t i = 0; i < voxels.voxels.size(); ++i) {
    const voxel::Voxel& voxel = voxels.voxels[i];
    const Vec3 p = representative(voxel);
    if (roles.casts.at(voxel.object) && view.can_shadow(p)) numbers.casters.push_back(i);
    if (roles.receives.at(voxel.object) && view.answers(p)) numbers.receivers.push_back(i);
  }
  return numbers;
}

}  // namespace gnomon::plan
