// SPDX-License-Identifier: Apache-2.0
// All techniques by name, and the hardware of several views.
#include "host/pipeline/technique.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "host/pipeline/kept_states.hpp"
#include "host/pipeline/slb_technique.hpp"
#include "host/pipeline/software_technique.hpp"
#include "host/pipeline/voxel_offset.hpp"
#include "host/pipeline/voxel_topology.hpp"

namespace gnomon::pipeline {
namespace {

using Techniques = std::vector<std::unique_ptr<Technique>>;
using Make = Result<std::unique_ptr<Technique>>(const RunSettings&, const TechniqueInput&);

Result<Techniques> each(const RunSettings& settings, std::span<const TechniqueInput> views, Make* make) {
  Techniques all;
  for (const TechniqueInput& view : views) {
    auto made = make(settings, view);
    if (!made) return fail(made.error().message);
    all.push_back(std::move(*made));
  }
  return all;
}

/// Vertices and queries are written for the plane of the hardware: every view gets the largest.
Result<Techniques> with_one_plane(RunSettings settings, std::span<const TechniqueInput> views, Make* make) {
  Result<Techniques> all = each(settings, views, make);
  if (!all) return all;
  for (const auto& technique : *all)
    settings.slb.plane_log2 = std::max(settings.slb.plane_log2, technique->config().slb_plane_log2);
  const bool alike = std::ranges::all_of(*all, [&](const auto& technique) {
    return technique->config().slb_plane_log2 == settings.slb.plane_log2;
  });
  return alike ? std::move(all) : each(settings, views, make);
}

bool is_directional_only(const std::string& technique) {
  return technique.starts_with("slb") || technique == "plain-map" || technique == "pcf";
}

}  // namespace

void Technique::ask(golden::StreamWriter&, std::span<const Receiver>) const {
  throw std::logic_error("this technique answers at voxels alone");
}

Result<std::vector<std::uint8_t>> Technique::answers(std::span<const golden::Word>, std::span<const Receiver>,
                                                     std::span<const golden::Word>) const {
  throw std::logic_error("this technique answers at voxels alone");
}

golden::HardwareConfig joined_hardware(golden::HardwareConfig a, const golden::HardwareConfig& b) {
  a.en_vpu_offset |= b.en_vpu_offset;
  a.en_vpu_topology |= b.en_vpu_topology;
  a.en_slb |= b.en_slb;
  a.en_frame_buffer |= b.en_frame_buffer;
  a.frame_layers_log2 = std::max(a.frame_layers_log2, b.frame_layers_log2);
  a.en_perspective |= b.en_perspective;
  a.plane_log2 = std::max(a.plane_log2, b.plane_log2);
  a.span_log2 = std::max(a.span_log2, b.span_log2);
  a.nodes_log2 = std::max(a.nodes_log2, b.nodes_log2);
  a.quads_log2 = std::max(a.quads_log2, b.quads_log2);
  a.slb_plane_log2 = std::max(a.slb_plane_log2, b.slb_plane_log2);
  return a;
}

namespace {

Result<Techniques> make_plain(const std::string& name, const RunSettings& settings,
                              std::span<const TechniqueInput> views) {
  if (name == "voxel-offset") return each(settings, views, make_voxel_offset);
  if (name == "voxel-topology") return each(settings, views, make_voxel_topology);
  if (name == "slb") return with_one_plane(settings, views, make_slb);
  if (name == "slb+voxel") return with_one_plane(settings, views, make_slb_with_voxels);
  if (name == "plain-map") return make_maps(settings, views, 1);
  if (name == "pcf") return make_maps(settings, views, settings.maps.kernel);
  if (name == "raycast") return make_ray_casters(settings, views);
  return fail(
      fmt::format("technique={} is unknown, expected one of voxel-offset, voxel-topology, slb, slb+voxel, "
                  "plain-map, pcf, raycast",
                  name));
}

}  // namespace

Result<Techniques> make_techniques(const std::string& name, const RunSettings& settings,
                                   std::span<const TechniqueInput> views) {
  if (settings.frame_buffer && is_software(name))
    return fail(fmt::format("frame_buffer=on keeps states in the hardware, and technique={} has none", name));
  Result<Techniques> all = make_plain(name, settings, views);
  return all && settings.frame_buffer ? keep_states(std::move(*all), views) : std::move(all);
}

Result<void> check_lights(const scene::Scene& scene, std::span<const std::string> techniques) {
  for (const std::string& technique : techniques) {
    if (!is_directional_only(technique)) continue;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      if (std::holds_alternative<DirectionalLight>(scene.lights[i])) continue;
      const bool spot = std::holds_alternative<SpotLight>(scene.lights[i]);
      return fail(fmt::format("{}: error: light {} is a {} light, technique={} takes directional lights only",
                              scene.source.string(), i + 1, spot ? "spot" : "point", technique));
    }
  }
  return {};
}

}  // namespace gnomon::pipeline
