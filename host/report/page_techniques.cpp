// SPDX-License-Identifier: Apache-2.0
// Several techniques side by side: a figure a line, a technique a column.
#include <fmt/format.h>

#include <functional>
#include <set>
#include <string>
#include <utility>

#include "host/report/numbers.hpp"
#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

using Cell = std::function<std::string(const Json& technique)>;

Json line(const Json& techniques, std::string name, const Cell& cell) {
  Json cells = Json::array();
  for (const Json& technique : techniques) cells.push_back({{"text", cell(technique)}});
  return {{"name", std::move(name)}, {"cells", cells}};
}

/// A dash where the technique has no such part.
Cell within(const char* part, Cell cell) {
  return [part, cell = std::move(cell)](const Json& t) {
    return t.at(part).is_null() ? kNone : cell(t.at(part));
  };
}

std::string wrong(const Json& errors, const char* among) {
  if (errors.is_null()) return kNone;
  return fmt::format("{} ({})", count(errors.at(among).at("mislabelled")),
                     share(errors.at(among).at("share")));
}

std::string displacement_in_voxels(const Json& errors) {
  const Json& entries = errors.at("fixed").at("boundary_displacement");
  return entries.is_null() ? kNone : fixed(entries.get<double>() * errors.at("pitch").get<double>(), 4);
}

std::string uncertain(const Json& t) {
  if (!t.at("topology").is_null()) return share(t.at("topology").at("uncertain_share"));
  return t.at("plane").is_null() ? kNone : share(t.at("voxels").at("uncertain_share"));
}

/// Total, and what of it was not work: "12,345 (hazard 1.2 %)".
std::string pass_text(const Json& t, const std::string& pass) {
  if (t.at("cycles").is_null()) return kNone;
  const Json& passes = t.at("cycles").at("by_pass");
  if (!passes.contains(pass) || passes.at(pass).at("total") == 0) return kNone;
  const auto total = passes.at(pass).at("total").get<std::uint64_t>();
  std::string text = with_commas(total);
  for (const auto& [cause, cycles] : passes.at(pass).at("causes").items()) {
    if (cause == "BUSY" || cycles == 0) continue;
    text += fmt::format("; {} {}", cause, percent(cycles.get<double>() / static_cast<double>(total)));
  }
  return text;
}

void add_errors(const Json& techniques, Json& rows) {
  const auto add = [&](const char* name, const Cell& cell) { rows.push_back(line(techniques, name, cell)); };
  add("words compared, differing", [](const Json& t) {
    const Json& compare = t.at("compare");
    if (!t.at("software").is_null()) return std::string("software");
    return compare.at("compared").get<bool>()
               ? count(compare.at("words")) + ", " + count(compare.at("differing"))
               : std::string("golden alone");
  });
  add("mislabelled, unambiguous",
      [](const Json& t) { return wrong(t.at("errors").at("fixed"), "unambiguous"); });
  add("the same in double", [](const Json& t) { return wrong(t.at("errors").at("double"), "unambiguous"); });
  add("mislabelled, steady", [](const Json& t) { return wrong(t.at("errors").at("fixed"), "steady"); });
  add("mislabelled, all", [](const Json& t) { return wrong(t.at("errors").at("fixed"), "all"); });
  add("the same in double", [](const Json& t) { return wrong(t.at("errors").at("double"), "all"); });
  add("fixed and double differ", [](const Json& t) {
    const Json& q = t.at("errors").at("quantisation");
    return q.is_null() ? kNone : fmt::format("{} ({})", count(q.at("differing")), share(q.at("share")));
  });
  add("boundary displacement, voxels", [](const Json& t) { return displacement_in_voxels(t.at("errors")); });
}

void add_work(const Json& techniques, Json& rows) {
  const auto add = [&](const char* name, const Cell& cell) { rows.push_back(line(techniques, name, cell)); };
  add("uncertain voxels", uncertain);
  add("entries hit", [](const Json& t) {
    const Json& part = t.at("plane").is_null() ? t.at("topology") : t.at("plane");
    return part.is_null() ? kNone : share(part.at("share_hit"));
  });
  add("voxels on an entry hit",
      within("plane", [](const Json& p) { return number(p.at("voxels_per_entry_hit"), 2); }));
  add("list length, mean and longest", within("topology", [](const Json& t) {
        return number(t.at("mean_list"), 2) + ", " + count(t.at("longest_list"));
      }));
  add("nodes visited, quads tested an uncertain voxel", within("topology", [](const Json& t) {
        return number(t.at("nodes_visited_per_uncertain"), 2) + ", " +
               number(t.at("quads_tested_per_uncertain"), 2);
      }));
  add("walks that a hit ended early", within("topology", [](const Json& t) { return count(t.at("hits")); }));
  add("texels; read a query", within("software", [](const Json& s) {
        const auto kernel = s.at("kernel").get<std::uint64_t>();
        return kernel == 0 ? std::string(kNone)
                           : fmt::format("{}²; {}", s.at("side").dump(), kernel * kernel);
      }));
  add("points asked in software", within("software", [](const Json& s) { return count(s.at("queries")); }));
  add("queries", within("slb", [](const Json& s) { return count(s.at("queries")); }));
}

void add_costs(const Json& techniques, Json& rows) {
  const auto add = [&](const std::string& name, const Cell& cell) {
    rows.push_back(line(techniques, name, cell));
  };
  std::set<std::string> passes;
  for (const Json& t : techniques) {
    if (t.at("cycles").is_null()) continue;
    for (const auto& [pass, figures] : t.at("cycles").at("by_pass").items())
      if (figures.at("total") != 0) passes.insert(pass);
  }
  for (const std::string& pass : passes)
    add("cycles, " + pass, [&pass](const Json& t) { return pass_text(t, pass); });
  add("cycles, all but READ", [](const Json& t) {
    const Json& cycles = t.at("run_time").at("cycles");
    return cycles.is_null() ? kNone : count(cycles);
  });
  add("cycles predicted; off", [](const Json& t) {
    const Json& predicted = t.at("cycles_predicted");
    if (predicted.is_null()) return std::string(kNone);
    const std::string total = count(predicted.at("total"));
    const Json& off = predicted.at("off");  // null with golden alone
    return off.is_null() ? total : total + "; " + count(off);
  });
  add("time at the clock", [](const Json& t) { return seconds(t.at("run_time").at("seconds_at_clock")); });
  const auto memory = [](const char* key) {
    return [key](const Json& t) {
      const auto size = t.at("memory").at(key).get<std::uint64_t>();
      return size == 0 ? std::string(kNone) : bits(size);
    };
  };
  add("memory: projection plane", memory("plane_bits"));
  add("memory: lists (heads, nodes, quads)", memory("topology_bits"));
  add("memory: silhouette-line buffer", memory("slb_plane_bits"));
  add("memory: frame buffer", memory("frame_buffer_bits"));
  add("memory: map, or rays' triangles and hierarchy", memory("software_bits"));
  add("memory, all", memory("hardware_bits"));
  add("memory traffic, bytes read + written", within("software", [](const Json& s) {
        return s.at("bytes_written") == 0 ? std::string(kNone)
                                          : count(s.at("bytes_read")) + " + " + count(s.at("bytes_written"));
      }));
  add("software: wall time to build, to answer", within("software", [](const Json& s) {
        return seconds(s.at("build_seconds")) + ", " + seconds(s.at("seconds"));
      }));
  add("command stream", memory("command_stream_bits"));
  add("result stream", memory("result_stream_bits"));
  add("host time", [](const Json& t) { return seconds(t.at("run_time").at("host_seconds")); });
}

}  // namespace

Json technique_section(const Json& m) {
  const Json& techniques = m.at("techniques");
  if (techniques.empty()) return {{"techniques", false}};
  Json names = Json::array();
  for (const Json& t : techniques) names.push_back({{"name", t.at("technique")}});
  Json rows = Json::array();
  add_errors(techniques, rows);
  add_work(techniques, rows);
  add_costs(techniques, rows);
  return {{"techniques", {{"names", names}, {"rows", rows}}}};
}

}  // namespace gnomon::report
