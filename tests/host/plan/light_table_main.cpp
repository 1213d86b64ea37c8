// SPDX-License-Identifier: Apache-2.0
// Prints the table of docs/vpu-topology.md, "Five lights": light_table RES MODEL.obj...
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gnomon/golden/golden_engine.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/metrics/shadow_truth.hpp"
#include "host/plan/topology_double.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/scene/scene.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon {
namespace {

using golden::VoxelState;
using States = std::vector<VoxelState>;

template <class T>
T require(Result<T> result) {
  if (result) return std::move(*result);
  fmt::print(stderr, "{}\n", result.error().message);
  std::exit(2);
}

/// Shares of mislabelled voxels, and what it took.
struct Figures {
  double unambiguous = 0, steady = 0, all = 0;  // per cent
  double uncertain = 0;                         // share of the voxels, per cent
  double tested = 0;                            // quads an uncertain voxel
};

/// One row: a method under a light, on all models.
struct Row {
  std::vector<std::pair<std::string, Figures>> models;

  double mean(double Figures::*figure) const {
    double sum = 0;
    for (const auto& [name, f] : models) sum += f.*figure;
    return sum / static_cast<double>(models.size());
  }
  std::string worst(double Figures::*figure) const {
    const auto at = std::ranges::max_element(
        models, {}, [&](const std::pair<std::string, Figures>& model) { return model.second.*figure; });
    return fmt::format("{:.4f} {}", at->second.*figure, at->second.*figure > 0 ? at->first : "");
  }
};
using Table = std::map<std::string, Row>;

/// A model on its own or on a ground, ready for any light.
struct Model {
  std::string name;
  std::vector<std::pair<std::string, Light>> lights;
  std::vector<surface::LimitSurface> surfaces;
  std::vector<bool> two_sided;
  voxel::VoxelSet voxels;
  std::vector<voxel::VoxelQuad> quads;
  std::vector<voxel::LimitQuad> limit;
};

/// Along an axis, 57 and 13 degrees above the ground, a point light and a spot beside the cage; in the world.
std::vector<std::pair<std::string, Light>> five_lights(const scene::Object& object) {
  Box3 box;
  for (const Vec3& p : object.mesh.positions) box.extendBy(p * object.to_world);
  const double size = std::max({box.size().x, box.size().y, box.size().z});
  const Vec3 middle = box.center();
  const Vec3 point = Vec3(middle.x, box.max.y, middle.z) + Vec3(-0.8, 0.6, 0.7) * size;
  const Vec3 spot = Vec3(middle.x, box.max.y, middle.z) + Vec3(-0.9, 1.1, 0.8) * size;
  const Vec3 target(middle.x, box.min.y, middle.z);
  const auto directional = [](const Vec3& way) { return DirectionalLight{way.normalized()}; };
  return {{"1 axis", directional({0, -1, 0})},
          {"2 oblique", directional({0.45, -1, -0.4})},
          {"3 grazing", directional({1, -0.25, -0.3})},
          {"4 point", PointLight{point}},
          {"5 spot", SpotLight{spot, (target - spot).normalized(), 30}}};
}

Model load(const std::string& path, std::uint32_t res, bool ground) {
  scene::SceneOptions options;
  options.ground = ground;
  const auto scene = require(scene::load_scene(path, options));
  const auto grid = require(scene::fit_grid(scene, res, voxel::Adjacency::N26));
  Model model{
      std::filesystem::path(path).stem().string(), five_lights(scene.objects.front()), {}, {}, {}, {}, {}};
  for (auto& [name, light] : model.lights) light = transformed(light, scene::to_grid(grid));
  for (const auto& object : scene.objects) {
    model.surfaces.push_back(
        require(surface::LimitSurface::build(object.mesh, scene::to_grid(object, grid))));
    model.two_sided.push_back(object.two_sided);
  }
  voxel::VoxelizerOptions voxelizer;
  voxelizer.subpatches = true;
  model.voxels = require(voxel::voxelize(model.surfaces, grid, voxelizer));
  model.quads = voxel::casting_quads(model.surfaces, model.voxels).quads;
  model.limit = voxel::limit_quads(model.surfaces, model.voxels);
  return model;
}

std::vector<golden::Word> run(golden::Engine& engine, const golden::StreamWriter& writer) {
  engine.submit(writer.words());
  std::vector<golden::Word> words;
  engine.drain(
      [&](std::span<const golden::Word> part) { words.insert(words.end(), part.begin(), part.end()); });
  return words;
}

/// All methods under one light, by their names; what a view does not reach is in shadow.
class Methods {
 public:
  Methods(const Model& model, const Light& light) : model_(model) {
    const auto roles = plan::ObjectRoles::all(model.two_sided);
    for (const plan::LightView& view : plan::light_views(light, model.voxels)) {
      const plan::ViewVoxels seen = plan::view_voxels(view, model.voxels, roles);
      if (seen.receivers.empty()) continue;
      offset(view, seen);
      for (const int bits : {0, 2, 4}) topology(view, seen, bits);
    }
  }
  struct Answers {
    States states;
    std::uint64_t uncertain = 0, tested = 0;
  };
  const std::map<std::string, Answers>& answers() const { return answers_; }

 private:
  Answers& of(const std::string& method) {
    Answers& answers = answers_[method];
    answers.states.resize(model_.voxels.voxels.size(), VoxelState::Shadow);
    return answers;
  }
  void offset(const plan::LightView& view, const plan::ViewVoxels& seen) {
    const auto plan = require(plan::plan_vpu(model_.voxels, view, seen, {}));
    const auto engine = golden::make_golden_engine(plan.config);
    golden::StreamWriter writer(plan.config);
    plan::write_vpu(writer, plan.config, plan, model_.voxels, seen, model_.two_sided);
    const auto results = require(plan::voxel_results(run(*engine, writer), seen.receivers.size()));
    Answers& to = of("offset");
    for (std::size_t i = 0; i < results.size(); ++i) to.states[seen.receivers[i]] = results[i].state;
    to.uncertain += engine->counters().events.at("RESOLVED_UNCERTAIN");
  }
  void topology(const plan::LightView& view, const plan::ViewVoxels& seen, int bits) {
    plan::TopologySettings settings;
    settings.voxel_frac_bits = bits;
    const auto plan = require(plan::plan_topology(model_.voxels, model_.quads, view, seen, settings));
    const auto engine = golden::make_golden_engine(plan.vpu.config);
    golden::StreamWriter writer(plan.vpu.config);
    plan::write_topology(writer, plan.vpu.config, plan, model_.voxels, seen.receivers, model_.two_sided);
    const auto results = require(plan::topology_results(run(*engine, writer), seen.receivers.size()));
    Answers& to = of(fmt::format("topology, {} bits", bits));
    for (std::size_t i = 0; i < results.size(); ++i)
      to.states[seen.receivers[i]] = results[i].shadow ? VoxelState::Shadow : VoxelState::Lit;
    to.uncertain += engine->counters().events.at("TOPOLOGY_UNCERTAIN");
    to.tested += engine->counters().events.at("QUADS_TESTED");
    if (bits != 2) return;
    const auto exact =
        plan::topology_states_double(plan, model_.voxels, model_.limit, seen.receivers, model_.two_sided);
    Answers& in_double = of("double, exact corners");
    for (std::size_t i = 0; i < exact.states.size(); ++i)
      in_double.states[seen.receivers[i]] = exact.states[i];
    in_double.uncertain += exact.uncertain;
    in_double.tested += exact.tested;
  }

  const Model& model_;
  std::map<std::string, Answers> answers_;
};

Figures figures_of(const metrics::ShadowTruth& truth, const Methods::Answers& answers) {
  const std::vector<std::uint8_t> every(truth.voxels.size(), 1);
  const auto share = [&](const std::vector<std::uint8_t>& among) {
    std::uint64_t compared = 0, wrong = 0;
    for (std::size_t i = 0; i < among.size(); ++i) {
      if (among[i] == 0) continue;
      ++compared;
      wrong += metrics::in_shadow(truth.voxels[i]) != (answers.states[i] == VoxelState::Shadow) ? 1U : 0U;
    }
    return compared == 0 ? 0.0 : 100.0 * static_cast<double>(wrong) / static_cast<double>(compared);
  };
  const auto uncertain = static_cast<double>(answers.uncertain);
  return {share(truth.unambiguous), share(truth.steady), share(every),
          100 * uncertain / static_cast<double>(truth.voxels.size()),
          uncertain > 0 ? static_cast<double>(answers.tested) / uncertain : 0.0};
}

void measure(const Model& model, Table& table) {
  const metrics::ExactReference reference(model.surfaces, model.two_sided, model.lights.front().second);
  for (const auto& [name, light] : model.lights) {
    const metrics::ExactReference lit = reference.relit(light);
    const auto truth = metrics::shadow_truth(lit, model.surfaces, model.voxels);
    const Methods methods(model, light);
    for (const auto& [method, answers] : methods.answers())
      table[fmt::format("{} | {}", method, name)].models.emplace_back(model.name, figures_of(truth, answers));
  }
}

void print(const Table& table) {
  fmt::print(
      "| method | light | unambiguous: mean | worst | steady: mean | worst | all: mean | uncertain | tested: "
      "mean | worst |\n|---|---|---|---|---|---|---|---|---|---|\n");
  const auto line = [](const std::string& name, const Row& row) {
    fmt::print("| {} | {:.4f} | {} | {:.4f} | {} | {:.3f} | {:.1f} | {:.2f} | {} |\n", name,
               row.mean(&Figures::unambiguous), row.worst(&Figures::unambiguous), row.mean(&Figures::steady),
               row.worst(&Figures::steady), row.mean(&Figures::all), row.mean(&Figures::uncertain),
               row.mean(&Figures::tested), row.worst(&Figures::tested));
  };
  std::map<std::string, Row> of_method;
  for (const auto& [name, row] : table) {
    line(name, row);
    Row& sum = of_method[name.substr(0, name.find(" |")) + " | all"];
    sum.models.insert(sum.models.end(), row.models.begin(), row.models.end());
  }
  for (const auto& [name, row] : of_method) line(name, row);
}

}  // namespace
}  // namespace gnomon

int main(int argc, char** argv) {
  using namespace gnomon;
  if (argc < 3) {
    fmt::print(stderr, "usage: light_table RES MODEL.obj...\n");
    return 1;
  }
  const auto res = static_cast<std::uint32_t>(std::stoul(argv[1]));
  for (const bool ground : {true, false}) {
    Table table;
    for (int i = 2; i < argc; ++i) measure(load(argv[i], res, ground), table);
    fmt::print("\n{}, {} models, {}^3, per cent\n\n", ground ? "On ground" : "Bare", argc - 2, res);
    print(table);
  }
  return 0;
}
