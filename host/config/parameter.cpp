// SPDX-License-Identifier: Apache-2.0
// The registry of parameters.
#include "host/config/parameter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "host/config/nearest.hpp"

namespace gnomon::config {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kLargestSeed = 4294967295;

Parameter integer(std::string_view key, std::int64_t preset, double low, double high, std::string_view unit,
                  std::string_view help) {
  return {key, Type::Integer, low, high, {}, preset, unit, help};
}

Parameter integer_of(std::string_view key, std::int64_t preset, std::vector<std::string_view> words,
                     std::string_view unit, std::string_view help) {
  return {key, Type::Integer, -kUnbounded, kUnbounded, std::move(words), preset, unit, help};
}

Parameter number(std::string_view key, double preset, double low, double high, std::string_view unit,
                 std::string_view help) {
  return {key, Type::Number, low, high, {}, preset, unit, help};
}

Parameter choice(std::string_view key, std::vector<std::string_view> words, std::string_view help) {
  std::string preset(words.front());
  return {key, Type::Choice, 0, 0, std::move(words), std::move(preset), "", help};
}

/// One of `words` or several, each once; the first is the default.
Parameter choices(std::string_view key, std::vector<std::string_view> words, std::string_view help) {
  std::string preset(words.front());
  return {key, Type::Choices, 0, 0, std::move(words), std::move(preset), "", help};
}

Parameter about(Part part, Parameter parameter) {
  parameter.part = part;
  return parameter;
}

/// The published encodings.
Parameter slb_preset() {
  Parameter preset =
      choice("slb_preset", {"slb7", "slb4"}, "sets frac_bits and slope_bits where nothing else does");
  preset.implies = {{"slb4", "frac_bits", std::int64_t{4}}, {"slb4", "slope_bits", std::int64_t{4}}};
  return preset;
}

/// 0: as few as the encoding allows.
std::vector<std::string_view> fraction_widths() {
  return {"0", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16"};
}

std::vector<Parameter> make_parameters() {
  return {
      integer("res", 256, 16, 2048, "voxels", "side of the voxel grid"),
      integer_of("adjacency", 26, {"6", "18", "26"}, "neighbours",
                 "which voxels count as neighbours of each other"),
      choices("technique",
              {"voxel-offset", "voxel-topology", "slb", "slb+voxel", "plain-map", "pcf", "raycast"},
              "how shadows are decided; several, with commas between them, are shown side by side"),
      integer_of("plane", 0, {"0", "16", "32", "64", "128", "256", "512", "1024", "2048", "4096"}, "entries",
                 "side of the technique's projection plane; 0: the smallest that holds the scene"),
      number("pitch", 1.4, 0.25, 16, "voxels/entry",
             "voxels per plane entry; voxel-topology takes 1 unless told"),
      number("offset", 0.7, 0, 8, "voxels", "how far an uncertain voxel moves along its normal"),
      number("margin", 1.5, 0, 8, "voxels",
             "slope-scaled margin of the offset test, per unit of tan(normal, light)"),
      number("margin_tan_max", 10, 0, 100, "", "the tangent at which the margin stops growing"),
      integer("depth_bits", 20, 8, 24, "bits", "width of a depth in the plane"),
      integer("voxel_frac_bits", -1, -1, 6, "bits",
              "fraction bits of a voxel's surface point, per axis; -1: as many as the voxel word leaves, at "
              "most 4"),
      integer_of("normal_bits", 0, {"0", "4", "5", "6", "7", "8", "9", "10", "11", "12"}, "bits",
                 "width of a normal's component; 0: as many as the voxel word leaves, at most 9"),
      integer("matrix_frac_bits", 22, 12, 28, "bits", "fraction bits of the projection matrix"),
      slb_preset(),
      integer("frac_bits", 7, 3, 8, "bits", "of a silhouette line's crossing"),
      integer("slope_bits", 7, 3, 9, "bits", "of a silhouette line's slope"),
      integer("frags", 2, 1, 4, "a pixel", "fragments of the silhouette-line buffer, two lines each"),
      choice("rounding", {"better", "published"}, "how a silhouette line's fields are rounded"),
      integer_of("subpixel_bits", 0, fraction_widths(), "bits",
                 "fraction bits of an outline's vertices; 0: as few as frac_bits and slope_bits allow"),
      integer_of("query_bits", 0, fraction_widths(), "bits",
                 "fraction bits of a point asked for; 0: as few as frac_bits allows"),
      number("lift", -1, -1, 8, "voxels",
             "voxel-topology: how far above its voxel a beam starts; -1: as the fraction bits ask for"),
      number("clearance", -1, -1, 64, "voxels",
             "voxel-topology: how much nearer a caster must be; -1: as the fraction bits ask for"),
      integer("sub_bits", 4, 2, 8, "bits", "voxel-topology: fraction bits of a position on the plane"),
      integer("span_log2", 4, 2, 6, "", "voxel-topology: log2 of the largest quad, in entries"),
      integer("nodes_log2", 0, 0, 24, "", "voxel-topology: log2 of the node pool; 0: as the scene needs"),
      integer("quads_log2", 0, 0, 24, "",
              "voxel-topology: log2 of the room for quads; 0: as the scene needs"),
      choice("order", {"surface", "tile"},
             "of what is sent: as the surface is walked, or by tiles of the light's plane"),
      choice("map_memory", {"slb", "voxel-offset", "voxel-topology"},
             "plain-map, pcf: the hardware technique whose memory the map fills"),
      integer("map_side", 0, 0, 16384, "texels", "plain-map, pcf: side of the map; 0: as map_memory says"),
      integer("pcf_kernel", 3, 2, 16, "texels", "pcf: side of the square of texels that a point reads"),
      number("ray_sag", 1.0 / 512, 1.0 / 2048, 1, "voxels",
             "raycast: how far its triangles may lie from the limit surface"),
      choice(
          "frame_buffer", {"off", "on"},
          "keep the states of voxels in the hardware and look them up; up to 2 GiB, a layer for each light"),
      choice("surface", {"catmull-clark", "polygon"},
             "what faces are: the cage of a smooth surface, or the surface itself"),
      choice("ground", {"on", "off"}, "put a ground under the models"),
      {"light",
       Type::Vector,
       -kUnbounded,
       kUnbounded,
       {},
       std::array{0.45, -1.0, -0.4},
       "",
       "the way the light travels; replaces the lights of a scene file"},
      choice("up", {"y", "z"}, "which axis of the models points up"),
      about(Part::System,
            choice("system_hardware", {"top", "core", "golden"},
                   "engine system: the simulated hardware with its bus; its units alone, or golden, a word a "
                   "cycle, behind a front end in SystemC")),
      about(
          Part::Memory,
          integer_of(
              "cache_kib", 0, {"0", "4", "8", "16", "32", "64"}, "KiB",
              "system, simulated or predicted: of each unit's cache, planes and lists in DRAM; 0: on chip")),
      about(Part::Memory,
            integer_of("line_ids", 16, {"8", "16", "32"}, "lines",
                       "system, simulated or predicted: of the caches, that may be under way to DRAM, and as "
                       "many from it")),
      about(Part::Memory,
            integer_of("axi_bits", 64, {"64", "128", "256", "512"}, "bits",
                       "system, simulated or predicted: width of the hardware's way to memory")),
      about(Part::Memory, integer("memory_latency", 20, 0, 10000, "cycles",
                                  "system, simulated or predicted: of DRAM's controller and wires")),
      about(Part::Memory, integer("bus_latency", 2, 0, 10000, "cycles",
                                  "system, simulated or predicted: of a transaction, besides its target's")),
      about(Part::System, integer("quantum", 1000, 1, 1000000, "cycles",
                                  "engine system: how far the processor may be ahead of the others")),
      about(Part::System, integer("dram_mib", 256, 32, 2048, "MiB", "engine system: size of the DRAM")),
      about(Part::Memory, integer("dram_banks", 8, 1, 1024, "banks",
                                  "system, simulated or predicted: each with one open row")),
      about(Part::Memory, integer("dram_row_bytes", 2048, 64, 65536, "bytes",
                                  "system, simulated or predicted: of a row of DRAM")),
      about(Part::Memory, integer("dram_rcd", 2, 0, 1000, "cycles",
                                  "system, simulated or predicted: to open a row of DRAM")),
      about(Part::Memory, integer("dram_rp", 2, 0, 1000, "cycles",
                                  "system, simulated or predicted: to close the row before")),
      about(Part::Memory, integer("dram_cas", 2, 0, 1000, "cycles",
                                  "system, simulated or predicted: to read a column of an open row")),
      about(Part::Memory, integer("dram_width", 8, 1, 64, "bytes",
                                  "system, simulated or predicted: that DRAM's data bus moves in a cycle")),
      number("clock_mhz", 100, 1, 10000, "MHz", "the clock at which cycles are told as time"),
      integer("image_width", 960, 16, 8192, "pixels", "width of the picture"),
      integer("image_height", 720, 16, 8192, "pixels", "height of the picture"),
      integer("threads", 0, 0, 1024, "threads", "threads of the host; 0: one per core"),
      integer("seed", 1, 0, kLargestSeed, "", "reset values of the simulated registers"),
  };
}

Result<double> parse_number(std::string_view key, std::string_view all, std::string_view text) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return fail(fmt::format("{}={} is not a finite number", key, all));
  }
  return value;
}

Result<Value> parse_vector(std::string_view key, std::string_view text) {
  // Commas or blanks between the numbers: both are what people type.
  std::array<double, 3> vector{};
  std::size_t count = 0;
  for (std::size_t at = text.find_first_not_of(", "); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(", ", at), text.size());
    const Result<double> component = parse_number(key, text, text.substr(at, end - at));
    if (!component) return tl::make_unexpected(component.error());
    if (count < vector.size()) vector[count] = *component;
    ++count;
    at = text.find_first_not_of(", ", end);
  }
  if (count != 3) return fail(fmt::format("{}={} has {} numbers, expected three: x,y,z", key, text, count));
  if (vector == std::array{0.0, 0.0, 0.0})
    return fail(fmt::format("{}={} is no direction, expected any length but zero", key, text));
  return vector;
}

Result<Value> parse_choices(const Parameter& parameter, std::string_view text) {
  std::vector<std::string_view> taken;
  for (const std::string_view word : split(text)) {
    if (std::ranges::find(parameter.words, word) == parameter.words.end()) {
      return fail(fmt::format("{}={} is unknown or not in this build, expected {}", parameter.key, word,
                              parameter.range()));
    }
    if (std::ranges::find(taken, word) != taken.end())
      return fail(fmt::format("{}={} names {} twice", parameter.key, text, word));
    taken.push_back(word);
  }
  return std::string(text);
}

}  // namespace

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0;;) {
    const std::size_t comma = text.find(',', at);
    words.push_back(text.substr(at, comma - at));
    if (comma == std::string_view::npos) return words;
    at = comma + 1;
  }
}

std::string Parameter::range() const {
  if (type == Type::Choices) return fmt::format("{}, or several: a,b", fmt::join(words, " | "));
  if (!words.empty()) return fmt::format("{}", fmt::join(words, " | "));
  if (type == Type::Vector) return "x,y,z";
  return fmt::format("{}..{}", low, high);
}

Result<Value> Parameter::parse(std::string_view text) const {
  const auto out_of_range = [&] { return fail(fmt::format("{}={} is out of range {}", key, text, range())); };
  switch (type) {
    case Type::Vector:
      return parse_vector(key, text);
    case Type::Choices:
      return parse_choices(*this, text);
    case Type::Choice:
      if (std::find(words.begin(), words.end(), text) == words.end()) {
        return fail(fmt::format("{}={} is unknown or not in this build, expected {}", key, text, range()));
      }
      return std::string(text);
    case Type::Number: {
      const Result<double> value = parse_number(key, text, text);
      if (!value) return tl::make_unexpected(value.error());
      if (*value < low || *value > high) return out_of_range();
      return *value;
    }
    case Type::Integer:
      break;
  }
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc::result_out_of_range) return out_of_range();
  if (status != std::errc{} || end != text.data() + text.size()) {
    return fail(fmt::format("{}={} is not an integer", key, text));
  }
  const bool listed =
      words.empty() || std::find(words.begin(), words.end(), std::to_string(value)) != words.end();
  if (!listed || static_cast<double>(value) < low || static_cast<double>(value) > high) return out_of_range();
  return value;
}

std::string Parameter::environment() const {
  std::string name(kEnvironmentPrefix);
  for (const char c : key) name += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return name;
}

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> all = make_parameters();
  return all;
}

Result<const Parameter*> find_parameter(std::string_view key) {
  std::vector<std::string_view> keys;
  for (const Parameter& parameter : parameters()) {
    if (parameter.key == key) return &parameter;
    keys.push_back(parameter.key);
  }
  return fail(fmt::format("unknown key '{}', {}", key, suggestion(key, keys)));
}

std::string to_text(const Value& value) {
  struct Writer {
    std::string operator()(std::int64_t v) const { return std::to_string(v); }
    std::string operator()(double v) const { return fmt::format("{}", v); }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const std::array<double, 3>& v) const {
      return fmt::format("{}", fmt::join(v, ","));
    }
  };
  return std::visit(Writer{}, value);
}

}  // namespace gnomon::config
