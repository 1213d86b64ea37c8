// SPDX-License-Identifier: Apache-2.0
// gnomon area: cells and clocks of the datapaths of a parameter set, estimated.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/area/area.hpp"
#include "host/cli/area_hardware.hpp"
#include "host/cli/command.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/scene_input.hpp"

namespace gnomon::cli {
namespace {

using Json = nlohmann::ordered_json;

Json cells_json(const area::Cells& c) {
  return {{"luts", c.luts},
          {"carries", c.carries},
          {"flip_flops", c.flip_flops},
          {"dsps", c.dsps},
          {"rams", c.rams}};
}

Json clock_json(const std::optional<area::Clock>& clock) {
  if (!clock || !clock->fits()) return nullptr;
  return {{"median_mhz", clock->median()},   {"lowest_mhz", clock->lowest()},
          {"highest_mhz", clock->highest()}, {"seeds", clock->mhz.size()},
          {"logic_cells_used", clock->used}, {"logic_cells_available", clock->available}};
}

std::string clock_text(const std::optional<area::Clock>& clock) {
  if (!clock) return "";
  if (!clock->fits()) return "does not fit";
  return fmt::format("{:.1f} ({:.1f}..{:.1f})", clock->median(), clock->lowest(), clock->highest());
}

class AreaCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command =
        program.add_subcommand("area", "Estimate cells and clock of the datapaths on one FPGA family");
    add_set_option(*command, set_);
    command->add_option("--seeds", seeds_, "How often each unit is placed; 0: cells alone")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    command->add_flag("--json", json_, "Print as JSON");
    command->footer("Example:\n  gnomon area --set technique=slb --set frac_bits=4 --set slope_bits=4");
    return command;
  }

  Result<int> run(Context& context) override {
    const Result<config::Settings> settings = load_settings(set_);
    if (!settings) return tl::make_unexpected(settings.error());
    const std::string technique = settings->words("technique").front();
    const auto hardware = area_hardware(*settings, technique);
    if (!hardware) return tl::make_unexpected(hardware.error());
    const std::vector<area::Unit> units = area::units_of(*hardware);
    if (units.empty()) return fail(fmt::format("technique={} has no hardware", technique));
    const auto all = estimate(context, units);
    if (!all) return tl::make_unexpected(all.error());
    if (json_) {
      print_json(technique, *all);
    } else {
      print_table(technique, *all);
    }
    return kDone;
  }

 private:
  Result<area::Area> estimate(Context& context, const std::vector<area::Unit>& units) const {
    ProgressLine line(context.show_progress);
    area::Estimator estimator;
    area::Area all;
    for (const area::Unit& unit : units) {
      if (context.interruption.flag().load()) throw Interrupted();
      line.update(unit.module, static_cast<double>(all.units.size()) / static_cast<double>(units.size()));
      auto one = estimator.estimate(unit, seeds_);
      if (!one) return tl::make_unexpected(one.error());
      all.add(std::move(*one));
    }
    return all;
  }

  static void print_table(const std::string& technique, const area::Area& all) {
    fmt::print("{}, iCE40 (estimates; memories are not counted)\n", technique);
    fmt::print("{:<22}{:>7}{:>9}{:>8}{:>6}{:>6}  {}\n", "unit", "LUT4", "carries", "FF", "DSP", "RAM",
               "alone on HX8K, MHz: median (range)");
    const auto row = [](const std::string& name, const area::Cells& c, const std::string& clock) {
      fmt::print("{:<22}{:>7}{:>9}{:>8}{:>6}{:>6}  {}\n", name, c.luts, c.carries, c.flip_flops, c.dsps,
                 c.rams, clock);
    };
    for (const area::UnitEstimate& one : all.units) {
      const std::string times = one.unit.count > 1 ? fmt::format("{} x ", one.unit.count) : "";
      row(times + one.unit.module, one.cells, clock_text(one.clock));
    }
    row("all", all.sum, all.clock_mhz() ? fmt::format("at most {:.1f}", *all.clock_mhz()) : "");
  }

  static void print_json(const std::string& technique, const area::Area& all) {
    Json units = Json::array();
    for (const area::UnitEstimate& one : all.units) {
      Json parameters = Json::object();
      for (const auto& [name, value] : one.unit.parameters) parameters[name] = value;
      units.push_back({{"module", one.unit.module},
                       {"count", one.unit.count},
                       {"parameters", parameters},
                       {"cells", cells_json(one.cells)},
                       {"clock", clock_json(one.clock)},
                       {"fits", !one.clock || one.clock->fits()}});
    }
    const auto clock = all.clock_mhz();
    const Json figures{{"technique", technique},
                       {"family", "iCE40"},
                       {"units", units},
                       {"cells", cells_json(all.sum)},
                       {"clock_mhz_at_most", clock ? Json(*clock) : Json(nullptr)}};
    fmt::print("{}\n", figures.dump(2));
  }

  std::vector<std::string> set_;
  int seeds_ = 3;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_area_command() {
  return std::make_unique<AreaCommand>();
}

}  // namespace gnomon::cli
