// SPDX-License-Identifier: Apache-2.0
// Errors, and the lights that they come from, as metrics.json has them.
#include "host/report/metrics_parts.hpp"

namespace gnomon::report {

Json counts_json(const MislabelCounts& counts) {
  const std::uint64_t wrong = counts.false_shadow + counts.false_lit;
  return {{"samples", counts.samples},
          {"mislabelled", wrong},
          {"share", ratio(wrong, counts.samples)},
          {"false_shadow", counts.false_shadow},
          {"false_lit", counts.false_lit}};
}

namespace {

Json part_json(const ErrorPart& part) {
  Json boundary = nullptr;
  if (part.boundary_displacement) boundary = *part.boundary_displacement;
  return {{"all", counts_json(part.all)},
          {"unambiguous", counts_json(part.unambiguous)},
          {"steady", counts_json(part.steady)},
          {"samples", counts_json(part.samples)},
          {"boundary_length", part.boundary_length},
          {"boundary_displacement", boundary}};
}

Json error_json(const ErrorRecord& error) {
  Json json = part_json(error.total);
  json["ground"] = part_json(error.ground);
  json["models"] = part_json(error.models);
  return json;
}

/// Where a light is and what it looks like, world coordinates.
Json place_json(const Light& light) {
  if (const auto* directional = std::get_if<DirectionalLight>(&light))
    return {{"type", "directional"}, {"direction", vector_json(directional->direction)}};
  if (const auto* spot = std::get_if<SpotLight>(&light))
    return {{"type", "spot"},
            {"position", vector_json(spot->position)},
            {"direction", vector_json(spot->direction)},
            {"angle", 2 * spot->half_angle}};
  return {{"type", "point"}, {"position", vector_json(std::get<PointLight>(light).position)}};
}

Json view_json(const ViewRecord& view) {
  return {{"name", view.name},
          {"casters", view.casters},
          {"receivers", view.receivers},
          {"plane", plane_json(view.plane, view.events)},
          {"topology", topology_json(view.topology, view.events)},
          {"slb", slb_json(view.slb, view.events)}};
}

}  // namespace

Json errors_json(const ErrorsRecord& errors) {
  Json json = {{"pitch", errors.pitch},
               {"fixed", error_json(errors.fixed)},
               {"double", nullptr},
               {"quantisation", nullptr},
               {"shadow_maps", Json::array()}};
  for (const ShadowMapRecord& map : errors.shadow_maps) {
    Json row = {{"side", map.side}, {"memory_bits", map.memory_bits}};
    row.update(error_json(map.error));
    json["shadow_maps"].push_back(row);
  }
  if (!errors.in_double) return json;
  const DoubleRecord& d = *errors.in_double;
  json["double"] = error_json(d.error);
  json["quantisation"] = {
      {"differing", d.differing},
      {"share", ratio(d.differing, errors.fixed.total.all.samples)},
      {"unambiguous_differing", d.differing_unambiguous},
      {"unambiguous_share", ratio(d.differing_unambiguous, errors.fixed.total.unambiguous.samples)}};
  return json;
}

Json exact_json(const ExactRecord& exact) {
  return {{"triangles", exact.triangles}, {"sag", exact.sag}, {"lift", exact.lift}, {"rays", exact.rays}};
}

Json lights_json(const RunRecord& record) {
  Json all = Json::array();
  for (const LightRecord& light : record.lights) {
    Json row = place_json(light.light);
    row["shadow"] = light.in_shadow;
    row["shadow_share"] = ratio(light.in_shadow, record.voxels);
    row["not_reached"] = light.not_reached;
    row["errors"] = errors_json(light.errors);
    row["exact_reference"] = exact_json(light.exact);
    row["mask"] = counts_json(light.mask);
    row["views"] = Json::array();
    for (const ViewRecord& view : light.views) row["views"].push_back(view_json(view));
    all.push_back(row);
  }
  return all;
}

}  // namespace gnomon::report
