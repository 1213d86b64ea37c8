// SPDX-License-Identifier: Apache-2.0
// What is said of several lights and views together.
#include <algorithm>

#include "host/pipeline/records.hpp"
#include "host/report/metrics_parts.hpp"
#include "host/slb/costs.hpp"

namespace gnomon::pipeline {
namespace {

using report::ErrorPart;
using report::LightRecord;
using report::ViewRecord;

void add(report::MislabelCounts& sum, const report::MislabelCounts& more) {
  sum.samples += more.samples;
  sum.false_shadow += more.false_shadow;
  sum.false_lit += more.false_lit;
}

/// Displacements weighted by the lengths of the borders that they lie along.
void add(ErrorPart& sum, const ErrorPart& more) {
  add(sum.all, more.all);
  add(sum.unambiguous, more.unambiguous);
  add(sum.steady, more.steady);
  add(sum.samples, more.samples);
  const double area = sum.boundary_displacement.value_or(0) * sum.boundary_length +
                      more.boundary_displacement.value_or(0) * more.boundary_length;
  sum.boundary_length += more.boundary_length;
  if (sum.boundary_length > 0) sum.boundary_displacement = area / sum.boundary_length;
}

void add(report::ErrorRecord& sum, const report::ErrorRecord& more) {
  add(sum.total, more.total);
  add(sum.ground, more.ground);
  add(sum.models, more.models);
}

void add(report::ErrorsRecord& sum, const report::ErrorsRecord& more) {
  add(sum.fixed, more.fixed);
  if (sum.in_double && more.in_double) {
    add(sum.in_double->error, more.in_double->error);
    sum.in_double->differing += more.in_double->differing;
    sum.in_double->differing_unambiguous += more.in_double->differing_unambiguous;
  }
  for (std::size_t i = 0; i < std::min(sum.shadow_maps.size(), more.shadow_maps.size()); ++i)
    add(sum.shadow_maps[i].error, more.shadow_maps[i].error);
}

void add(report::PlaneRecord& sum, const report::PlaneRecord& more) {
  sum.entries_hit += more.entries_hit;
  sum.pitch += more.pitch;
  sum.views += more.views;
}

void add(report::TopologyRecord& sum, const report::TopologyRecord& more) {
  sum.lists += more.lists;
  sum.longest = std::max(sum.longest, more.longest);
  sum.pitch += more.pitch;
  sum.views += more.views;
}

void add(report::SlbRecord& sum, const report::SlbRecord& more) {
  for (std::size_t i = 0; i < sum.pixels_by_fragments.size(); ++i)
    sum.pixels_by_fragments[i] += more.pixels_by_fragments[i];
  sum.full_pixels += more.full_pixels;
  sum.overflow_pixels += more.overflow_pixels;
  sum.pitch += more.pitch;
  sum.views += more.views;
}

/// Memory serves one view after the other.
void add(report::SoftwareRecord& sum, const report::SoftwareRecord& more) {
  sum.side = std::max(sum.side, more.side);
  sum.pitch += more.pitch;
  sum.memory_bits = std::max(sum.memory_bits, more.memory_bits);
  sum.queries += more.queries;
  sum.drawn += more.drawn;
  sum.bytes_read += more.bytes_read;
  sum.bytes_written += more.bytes_written;
  sum.triangles = std::max(sum.triangles, more.triangles);
  sum.build_seconds += more.build_seconds;
  sum.seconds += more.seconds;
  sum.views += more.views;
}

template <class Part>
void add(std::optional<Part>& sum, const std::optional<Part>& more) {
  if (!more) return;
  if (sum) {
    add(*sum, *more);
  } else {
    sum = *more;
  }
}

/// The bits that docs/vpu-topology.md, "Memory", gives for one hardware, however many views it serves.
void add_memory(report::TopologyRecord& record, const golden::HardwareConfig& hardware) {
  const auto d = static_cast<std::uint64_t>(hardware.depth_bits);
  const auto nodes = static_cast<std::uint64_t>(hardware.nodes_log2);
  const auto quads = static_cast<std::uint64_t>(hardware.quads_log2);
  record.head_bits = 10 + d + nodes;
  record.node_bits = (std::uint64_t{1} << nodes) * (1 + nodes + d + quads);
  record.record_bits =
      (std::uint64_t{1} << quads) *
      static_cast<std::uint64_t>(2 * hardware.span_log2 + 8 * (hardware.span_log2 + hardware.sub_bits));
}

void add_views(report::RunRecord& record) {
  for (const LightRecord& light : record.lights) {
    for (const ViewRecord& view : light.views) {
      if (record.registers.empty()) record.registers = view.registers;
      add(record.plane, view.plane);
      add(record.topology, view.topology);
      add(record.slb, view.slb);
      add(record.software, view.software);
    }
  }
  const auto side = static_cast<std::uint32_t>(record.hardware.plane_side());
  if (record.plane) {
    record.plane->side = side;
    record.plane->pitch /= record.plane->views;
  }
  if (record.topology) {
    record.topology->side = side;
    record.topology->pitch /= record.topology->views;
    add_memory(*record.topology, record.hardware);
  }
  if (record.slb) record.slb->pitch /= record.slb->views;
  if (record.software) record.software->pitch /= record.software->views;
}

}  // namespace

void add_totals(report::RunRecord& record) {
  add_views(record);
  const LightRecord& first = record.lights.front();
  record.errors = first.errors;
  record.exact = first.exact;
  record.voxels_in_shadow = first.in_shadow;
  for (std::size_t i = 1; i < record.lights.size(); ++i) {
    const LightRecord& light = record.lights[i];
    add(record.errors, light.errors);
    record.errors.pitch += light.errors.pitch;
    record.exact.rays += light.exact.rays;
    record.voxels_in_shadow += light.in_shadow;
  }
  record.errors.pitch /= static_cast<double>(record.lights.size());
}

void add_cycles(std::vector<report::PassCycles>& sum, const std::vector<report::PassCycles>& more) {
  for (const report::PassCycles& pass : more) {
    auto at = std::ranges::find(sum, pass.pass, &report::PassCycles::pass);
    if (at == sum.end()) at = sum.insert(at, report::PassCycles{pass.pass, {}});
    for (const auto& [cause, cycles] : pass.causes) at->causes[cause] += cycles;
  }
}

std::uint64_t hardware_memory_bits(const golden::HardwareConfig& hardware) {
  std::uint64_t bits = 0;
  const auto side = static_cast<std::uint64_t>(hardware.plane_side());
  if (hardware.en_vpu_offset) bits += side * side * report::kPlaneEntryBits;
  if (hardware.en_vpu_topology) {
    report::TopologyRecord lists;
    lists.side = static_cast<std::uint32_t>(side);
    add_memory(lists, hardware);
    bits += report::topology_bits(lists);
  }
  if (hardware.en_slb) bits += slb::buffer_costs(hardware, {}).memory_bits;
  return bits;
}

}  // namespace gnomon::pipeline
