// SPDX-License-Identifier: Apache-2.0
// Prints the figures of docs/vpu-topology.md, "Measured", for models: topology_figures RES MODEL.obj...
#include <fmt/format.h>

#include <array>
#include <cstdlib>

#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_truth.hpp"
#include "host/plan/topology_double.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/scene/scene.hpp"
#include "host/voxel/voxelizer.hpp"
#include "tests/host/plan/topology_run.hpp"

namespace gnomon {
namespace {

constexpr std::array<std::array<double, 3>, 3> kLights = {{{0, -1, 0}, {0.45, -1, -0.4}, {1, -0.25, -0.3}}};

template <class T>
T require(Result<T> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", result.error().message);
  std::exit(2);
}

/// Sums over scenes.
struct Row {
  double share = 0, worst = 0, all = 0;  // of mislabelled voxels
  std::uint64_t scenes = 0, voxels = 0, uncertain = 0, visited = 0, tested = 0, fallback = 0;

  void add(const metrics::ShadowTruth& truth, std::span<const golden::VoxelState> states) {
    std::uint64_t wrong = 0, clear = 0, clear_wrong = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const bool differs = metrics::in_shadow(truth.voxels[i]) != (states[i] == golden::VoxelState::Shadow);
      wrong += differs ? 1U : 0U;
      if (truth.unambiguous[i] == 0) continue;
      ++clear;
      clear_wrong += differs ? 1U : 0U;
    }
    const double part = 100.0 * static_cast<double>(clear_wrong) / static_cast<double>(clear);
    share += part;
    worst = std::max(worst, part);
    all += 100.0 * static_cast<double>(wrong) / static_cast<double>(states.size());
    ++scenes;
    voxels += states.size();
  }
  void print(const std::string& name) const {
    const auto per = [](std::uint64_t a, std::uint64_t b) {
      return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
    };
    const auto n = static_cast<double>(scenes);
    fmt::print(
        "{:28} unambiguous {:.4f} % worst {:.4f} %  all {:.3f} %  uncertain {:.1f} %  visited {:.2f}  tested "
        "{:.2f}  fallback {}\n",
        name, share / n, worst, all / n, 100 * per(uncertain, voxels), per(visited, uncertain),
        per(tested, uncertain), fallback);
  }
};

struct Lists {
  std::uint64_t nodes = 0, entries = 0, quads = 0, voxels = 0;
  std::uint64_t insertion = 0;  // nodes passed, were the hardware to keep lists sorted: half of each list
  std::uint32_t longest = 0;
  void add(const plan::TopologyPlan& plan) {
    for (const std::uint32_t length : plan.list_length) {
      nodes += length;
      if (length > 0) insertion += std::uint64_t{length} * (length - 1) / 4;
      entries += length > 0 ? 1U : 0U;
      longest = std::max(longest, length);
    }
    quads += plan.quads.size();
    voxels += plan.items.size();
  }
};

/// All rows, for scenes with or without a ground.
struct Table {
  Row exact;
  std::array<Row, 5> fixed;
  Row unsorted;
  Lists lists;
};

std::vector<golden::VoxelState> states_of(const test::TopologyRun& run) {
  std::vector<golden::VoxelState> states;
  for (const auto& r : run.results)
    states.push_back(r.shadow ? golden::VoxelState::Shadow : golden::VoxelState::Lit);
  return states;
}

void measure(const std::string& path, std::uint32_t res, bool ground, const Vec3& light, Table& table) {
  scene::SceneOptions options;
  options.ground = ground;
  options.light = light;
  const auto scene = require(scene::load_scene(path, options));
  const auto grid = require(scene::fit_grid(scene, res, voxel::Adjacency::N26));
  std::vector<surface::LimitSurface> surfaces;
  std::vector<bool> two_sided;
  for (const auto& object : scene.objects) {
    surfaces.push_back(require(surface::LimitSurface::build(object.mesh, scene::to_grid(object, grid))));
    two_sided.push_back(object.two_sided);
  }
  voxel::VoxelizerOptions voxelizer;
  voxelizer.subpatches = true;
  const auto voxels = require(voxel::voxelize(surfaces, grid, voxelizer));
  const Vec3 travel = std::get<DirectionalLight>(scene.lights[0]).direction;
  const metrics::ExactReference reference(surfaces, two_sided, metrics::DirectionalLight{travel});
  const auto truth = metrics::shadow_truth(reference, surfaces, voxels);
  const auto casting = voxel::casting_quads(surfaces, voxels);

  const auto fixed = [&](const plan::TopologySettings& settings, Row& row) {
    auto plan = require(plan::plan_topology(voxels, casting.quads, travel, settings));
    const auto run = test::run_topology(plan, voxels, two_sided);
    row.add(truth, states_of(run));
    row.uncertain += run.events.at("TOPOLOGY_UNCERTAIN");
    row.visited += run.events.at("NODES_VISITED");
    row.tested += run.events.at("QUADS_TESTED");
    row.fallback += run.events.at("TOPOLOGY_FALLBACK");
    return plan;
  };
  for (int bits = 0; bits < 5; ++bits) {
    plan::TopologySettings settings;
    settings.voxel_frac_bits = bits;
    settings.normal_bits = std::min(9, 21 - bits - static_cast<int>(std::bit_width(res - 1)));
    const auto plan = fixed(settings, table.fixed[static_cast<std::size_t>(bits)]);
    if (bits == 2) table.lists.add(plan);
  }
  plan::TopologySettings settings;
  settings.voxel_frac_bits = 2;
  settings.sorted = false;
  const auto plan = fixed(settings, table.unsorted);
  const auto exact = plan::topology_states_double(plan, voxels, voxel::limit_quads(surfaces, voxels),
                                                  plan::all_voxels(voxels).receivers, two_sided);
  table.exact.add(truth, exact.states);
  table.exact.uncertain += exact.uncertain;
  table.exact.tested += exact.tested;
}

}  // namespace
}  // namespace gnomon

int main(int argc, char** argv) {
  using namespace gnomon;
  if (argc < 3) {
    fmt::print(stderr, "usage: topology_figures RES MODEL.obj...\n");
    return 1;
  }
  const auto res = static_cast<std::uint32_t>(std::stoul(argv[1]));
  for (const bool ground : {true, false}) {
    Table table;
    for (int i = 2; i < argc; ++i)
      for (const auto& light : kLights) measure(argv[i], res, ground, {light[0], light[1], light[2]}, table);
    fmt::print("{}\n", ground ? "on ground" : "bare");
    table.exact.print("double, exact corners");
    for (std::size_t bits = 0; bits < table.fixed.size(); ++bits)
      table.fixed[bits].print(fmt::format("fixed, {} fraction bits", bits));
    table.unsorted.print("fixed, 2, lists not sorted");
    const auto& lists = table.lists;
    fmt::print(
        "quads a voxel {:.2f}, nodes a quad {:.2f}, list length mean {:.1f} longest {}, sorted insertion "
        "would "
        "pass {:.1f} nodes\n",
        static_cast<double>(lists.quads) / static_cast<double>(lists.voxels),
        static_cast<double>(lists.nodes) / static_cast<double>(lists.quads),
        static_cast<double>(lists.nodes) / static_cast<double>(lists.entries), lists.longest,
        static_cast<double>(lists.insertion) / static_cast<double>(lists.nodes));
  }
  return 0;
}
