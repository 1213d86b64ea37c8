// SPDX-License-Identifier: Apache-2.0
// One artifact of the cache a unit and number of seeds: its estimate as JSON.
#include "host/area/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "host/area/wrapper.hpp"
#include "sim/artifact_cache.hpp"
#include "sim/content_hash.hpp"
#include "sim/process.hpp"

namespace gnomon::area {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kMethod = "1";  ///< grows when what is done below changes
constexpr const char* kPlacing = "--hx8k --package ct256 --pcf-allow-unconstrained --timing-allow-fail -q";

/// What a tool could not do, in its own words.
class ToolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Comments and options aside.
std::vector<std::string> listed_files(const fs::path& list) {
  std::vector<std::string> files;
  std::istringstream lines(sim::read_file(list));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && !line.starts_with("//") && !line.starts_with("+")) files.push_back(line);
  }
  return files;
}

std::string without_comments(const std::string& text) {
  static const std::regex comment("//[^\n]*");
  return std::regex_replace(text, comment, "");
}

bool names(const std::string& text, const std::string& word) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_part(text[at - 1])) && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}

/// The unit's file and all that it names, and that those name: modules and packages lie in files of their
/// names. In the order of `listed`.
std::vector<std::string> files_of(const Unit& unit, const fs::path& rtl,
                                  const std::vector<std::string>& listed) {
  std::set<std::string> needed;
  std::vector<std::string> open{unit.module};
  while (!open.empty()) {
    const std::string module = open.back();
    open.pop_back();
    for (const std::string& file : listed) {
      if (fs::path(file).stem() != module || !needed.insert(file).second) continue;
      const std::string text = without_comments(sim::read_file(rtl / file));
      for (const std::string& other : listed) {
        const std::string stem = fs::path(other).stem().string();
        if (!needed.contains(other) && names(text, stem)) open.push_back(stem);
      }
    }
  }
  std::vector<std::string> files;
  std::ranges::copy_if(listed, std::back_inserter(files),
                       [&](const std::string& file) { return needed.contains(file); });
  return files;
}

std::string settings_of(const Unit& unit) {
  std::string text;
  for (const auto& [name, value] : unit.parameters) text += fmt::format(" -set {} {}", name, value);
  return text.empty() ? text : fmt::format("chparam{} {}; ", text, unit.module);
}

/// The line that says what went wrong.
std::string complaint(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("ERROR") != std::string::npos) return line;
  }
  return "failed without saying why";
}

bool succeeds(const std::vector<std::string>& words, const fs::path& directory, const fs::path& log) {
  fs::remove(log);
  try {
    return sim::Process(words, directory, log).succeeded();
  } catch (const std::runtime_error&) {
    throw ToolError(
        fmt::format("{} is not there; Debian's packages are yosys and nextpnr-ice40", words.front()));
  }
}

/// A line a tool that an estimate comes from; with other tools it would be another.
std::string versions_of_tools(int seeds) {
  std::string lines;
  for (const char* tool : {"yosys", "nextpnr-ice40"}) {
    if (seeds == 0 && tool != std::string_view("yosys")) continue;
    try {
      lines += sim::version_of(tool);
    } catch (const std::runtime_error&) {
      throw ToolError(fmt::format("{} is not there; Debian's packages are yosys and nextpnr-ice40", tool));
    }
  }
  return lines;
}

/// One unit's runs in a folder of its own.
class Work {
 public:
  Work(const Unit& unit, const fs::path& rtl, const std::vector<std::string>& files, fs::path folder)
      : unit_(unit),
        folder_(std::move(folder)),
        read_(fmt::format("read_verilog -sv -I{}", (rtl / "common").string())) {
    for (const std::string& file : files) read_.append(" ").append((rtl / file).string());
    read_ += "; ";
  }

  Cells cells() const {
    // Yosys gives a top module that it has to read anew, because a part's ports were not known at first, the
    // name that its parameters make.
    yosys(fmt::format(
        "{0}{2}hierarchy -top {1}; rename -top {1}; proc; write_json ports.json; synth_ice40 -dsp "
        "-top {1}; tee -q -o stat.json stat -json",
        read_, unit_.module, settings_of(unit_)));
    const Json all = Json::parse(sim::read_file(folder_ / "stat.json"));
    Cells cells;
    for (const auto& [kind, count] : all.at("design").at("num_cells_by_type").items()) {
      const auto number = count.get<std::uint64_t>();
      if (kind == "SB_LUT4") cells.luts += number;
      if (kind == "SB_CARRY") cells.carries += number;
      if (kind.starts_with("SB_DFF")) cells.flip_flops += number;
      if (kind == "SB_MAC16") cells.dsps += number;
      if (kind == "SB_RAM40_4K") cells.rams += number;
    }
    return cells;
  }

  /// Needs the ports that cells() has left. The parameters are the wrapper's to give.
  Clock clock(int seeds) const {
    const Json ports = Json::parse(sim::read_file(folder_ / "ports.json"));
    sim::write_file(folder_ / "wrapper.v", wrapper(unit_, ports_of(ports, unit_.module)));
    yosys(
        fmt::format("{}read_verilog wrapper.v; hierarchy -top area_wrapper; synth_ice40 -top area_wrapper "
                    "-json wrapped.json",
                    read_));
    Clock clock;
    for (int seed = 1; seed <= seeds; ++seed)
      if (!place(seed, clock)) break;
    return clock;
  }

 private:
  void yosys(const std::string& script) const {
    const fs::path log = folder_ / "yosys.log";
    if (!succeeds({"yosys", "-q", "-p", script}, folder_, log))
      throw ToolError(fmt::format("{}: yosys: {}", unit_.module, complaint(sim::read_file(log))));
  }

  bool place(int seed, Clock& clock) const {
    std::vector<std::string> words{"nextpnr-ice40"};
    std::istringstream options(kPlacing);
    for (std::string word; options >> word;) words.push_back(word);
    words.insert(words.end(),
                 {"--seed", std::to_string(seed), "--json", "wrapped.json", "--report", "report.json"});
    const fs::path log = folder_ / "nextpnr.log";
    if (!succeeds(words, folder_, log)) {
      const std::string text = sim::read_file(log);
      // Only that it is too large is an answer.
      if (text.find("nable to place") == std::string::npos &&
          text.find("nable to find legal placement") == std::string::npos)
        throw ToolError(fmt::format("{}: nextpnr-ice40: {}", unit_.module, complaint(text)));
      clock.mhz.clear();
      return false;
    }
    const Json report = Json::parse(sim::read_file(folder_ / "report.json"));
    const Json& cells = report.at("utilization").at("ICESTORM_LC");
    clock.used = cells.at("used").get<std::uint64_t>();
    clock.available = cells.at("available").get<std::uint64_t>();
    double slowest = 0;
    for (const auto& [name, figures] : report.at("fmax").items())
      slowest = figures.at("achieved").get<double>();
    clock.mhz.push_back(slowest);
    return true;
  }

  const Unit& unit_;
  fs::path folder_;
  std::string read_;
};

/// `clock`: null if it was not asked for.
Json to_json(const Cells& c, const Clock* clock) {
  Json json = {{"luts", c.luts},
               {"carries", c.carries},
               {"flip_flops", c.flip_flops},
               {"dsps", c.dsps},
               {"rams", c.rams}};
  if (clock != nullptr)
    json["clock"] = {{"mhz", clock->mhz}, {"used", clock->used}, {"available", clock->available}};
  return json;
}

UnitEstimate from_json(const Unit& unit, const Json& json) {
  const auto count = [&](const char* key) { return json.at(key).get<std::uint64_t>(); };
  UnitEstimate estimate{unit,
                        {count("luts"), count("carries"), count("flip_flops"), count("dsps"), count("rams")},
                        std::nullopt};
  if (json.contains("clock")) {
    const Json& clock = json.at("clock");
    estimate.clock = Clock{clock.at("mhz").get<std::vector<double>>(), clock.at("used").get<std::uint64_t>(),
                           clock.at("available").get<std::uint64_t>()};
  }
  return estimate;
}

}  // namespace

Cells& Cells::operator+=(const Cells& other) {
  luts += other.luts;
  carries += other.carries;
  flip_flops += other.flip_flops;
  dsps += other.dsps;
  rams += other.rams;
  return *this;
}

Cells Cells::operator*(std::uint64_t times) const {
  return {luts * times, carries * times, flip_flops * times, dsps * times, rams * times};
}

double Clock::lowest() const {
  return *std::ranges::min_element(mhz);
}
double Clock::highest() const {
  return *std::ranges::max_element(mhz);
}
double Clock::median() const {
  std::vector<double> sorted = mhz;
  std::ranges::sort(sorted);
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

Estimator::Estimator(sim::Toolchain tools)
    : tools_(std::move(tools)), listed_(listed_files(tools_.rtl_dir / "gnomon.f")) {}

Result<UnitEstimate> Estimator::estimate(const Unit& unit, int seeds) try {
  const std::vector<std::string> files = files_of(unit, tools_.rtl_dir, listed_);
  std::string manifest = fmt::format("area method {}, {} seeds, {}\n{} {}\n", kMethod, seeds, kPlacing,
                                     unit.module, settings_of(unit)) +
                         versions_of_tools(seeds);
  for (const std::string& file : files)
    manifest += fmt::format("{} {}\n", file, sim::content_hash(sim::read_file(tools_.rtl_dir / file)));
  manifest += sim::content_hash(sim::read_file(tools_.rtl_dir / "common" / "assertions.svh"));
  const sim::ArtifactCache cache(tools_.cache_dir);
  const auto found = cache.get({"area", manifest, "estimate.json"}, [&](const fs::path& folder) {
    ++runs_;
    const Work work(unit, fs::absolute(tools_.rtl_dir), files, folder);
    const Cells cells = work.cells();
    Clock clock;
    if (seeds > 0) clock = work.clock(seeds);
    sim::write_file(folder / "estimate.json", to_json(cells, seeds > 0 ? &clock : nullptr).dump());
  });
  return from_json(unit, Json::parse(sim::read_file(found.product)));
} catch (const ToolError& error) {
  return fail(error.what());
}

}  // namespace gnomon::area
