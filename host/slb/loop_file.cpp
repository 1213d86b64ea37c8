// SPDX-License-Identifier: Apache-2.0
// Reads polygon loops from a JSON file.
#include "host/slb/loop_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "host/slb/json_text.hpp"

namespace gnomon::slb {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestValue = 60;  // of one that a message repeats

/// "object 0, loop 1, vertex 2 (objects[0].loops[1][2])"; the path alone where it leads elsewhere.
std::string describe(const JsonPath& path) {
  const auto key = [&](std::size_t at, const char* name) {
    const auto* text = at < path.size() ? std::get_if<std::string>(&path[at]) : nullptr;
    return text != nullptr && *text == name;
  };
  const auto index = [&](std::size_t at) -> std::optional<std::size_t> {
    const auto* number = at < path.size() ? std::get_if<std::size_t>(&path[at]) : nullptr;
    return number == nullptr ? std::nullopt : std::optional(*number);
  };
  const std::optional<std::size_t> object = index(1);
  if (!key(0, "objects") || !object) return to_text(path);
  if (path.size() == 2) return place_text(*object);
  if (path.size() > 3 && key(2, "loops")) return place_text(*object, index(3), index(4));
  return fmt::format("object {} ({})", *object, to_text(path));
}

std::string kind_of(const json& value) {
  if (value.is_array()) return fmt::format("an array of {}", value.size());
  if (value.is_object()) return "an object";
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kLongestValue ? text : text.substr(0, kLongestValue) + "...";
}

/// Turns the tree into casters; the first fault ends it.
class Reader {
 public:
  explicit Reader(std::filesystem::path path) : path_(std::move(path)) {}

  Result<LoopFile> read(const json& root) {
    if (!root.is_object()) return refuse("", kind_of(root), R"({"objects": [...]})");
    note_other_keys(root, {"objects"});
    const auto objects = root.find("objects");
    if (objects == root.end()) return refuse("", "there is no key 'objects'", "an array of objects");
    if (!objects->is_array()) return refuse("objects", kind_of(*objects), "an array of objects");
    for (const json& object : *objects) {
      if (Result<void> done = read_object(object); !done) return tl::make_unexpected(done.error());
    }
    note_repeats();
    return std::move(file_);
  }

 private:
  tl::unexpected<Error> refuse(const std::string& where, const std::string& found,
                               const std::string& expected) const {
    return fail(fmt::format("{}: error: {}{}{}, expected {}", path_.string(), where,
                            where.empty() ? "" : ": ", found, expected));
  }
  tl::unexpected<Error> refuse(const std::string& found, const std::string& expected) const {
    return refuse(describe(at_), found, expected);
  }

  Result<void> read_object(const json& object) {
    at_ = {std::string("objects"), file_.scene.size()};
    if (!object.is_object()) return refuse(kind_of(object), R"({"depth": ..., "loops": [...]})");
    note_other_keys(object, {"depth", "loops"});
    FlatCaster caster;
    const auto depth = object.find("depth"), loops = object.find("loops");
    if (depth == object.end()) return refuse("there is no key 'depth'", "a number 0..1");
    if (!depth->is_number()) return refuse("depth is " + kind_of(*depth), "a number 0..1");
    caster.depth = depth->get<double>();
    if (!(caster.depth >= 0 && caster.depth <= 1))
      return refuse(fmt::format("depth is {}", caster.depth), "0..1");
    if (loops == object.end()) return refuse("there is no key 'loops'", "an array of loops");
    if (!loops->is_array()) return refuse("loops is " + kind_of(*loops), "an array of loops");
    at_.emplace_back(std::string("loops"));
    for (const json& loop : *loops) {
      at_.emplace_back(caster.loops.size());
      Result<Loop> vertices = read_loop(loop);
      if (!vertices) return tl::make_unexpected(vertices.error());
      caster.loops.push_back(std::move(*vertices));
      at_.pop_back();
    }
    file_.scene.push_back(std::move(caster));
    return {};
  }

  Result<Loop> read_loop(const json& vertices) {
    if (!vertices.is_array()) return refuse(kind_of(vertices), "an array of vertices [x, y]");
    Loop loop;
    loop.reserve(vertices.size());
    for (const json& vertex : vertices) {
      at_.emplace_back(loop.size());
      const bool pair = vertex.is_array() && vertex.size() == 2;
      if (!pair) return refuse(kind_of(vertex), "[x, y]");
      for (const std::size_t axis : {0U, 1U}) {
        if (!vertex[axis].is_number())
          return refuse(fmt::format("{} is {}", axis == 0 ? 'x' : 'y', kind_of(vertex[axis])),
                        "a finite number");
      }
      loop.emplace_back(vertex[0].get<double>(), vertex[1].get<double>());
      at_.pop_back();
    }
    const bool repeats = loop.size() > 1 && loop.front() == loop.back();
    if (repeats) loop.pop_back();
    if (loop.size() < 3) {
      return refuse(fmt::format("{} {}{}", loop.size(), loop.size() == 1 ? "vertex" : "vertices",
                                repeats ? " (the last repeats the first)" : ""),
                    "three or more");
    }
    if (repeats && repeats_++ == 0) first_repeat_ = describe(at_);
    return loop;
  }

  void note_other_keys(const json& table, std::initializer_list<const char*> known) {
    for (const auto& [key, value] : table.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      JsonPath path = at_;
      path.emplace_back(key);
      file_.notes.push_back(fmt::format("{}: {}: key ignored", path_.string(), describe(path)));
    }
  }

  void note_repeats() {
    if (repeats_ == 0) return;
    file_.notes.push_back(fmt::format(
        "{}: {}: the last vertex repeats the first and is left out{}", path_.string(), first_repeat_,
        repeats_ == 1 ? "" : fmt::format("; so it is in {} more loops", repeats_ - 1)));
  }

  std::filesystem::path path_;
  LoopFile file_;
  JsonPath at_;
  std::size_t repeats_ = 0;
  std::string first_repeat_;
};

}  // namespace

Result<LoopFile> read_loops(const std::filesystem::path& path) {
  const Result<json> root = read_json(path, describe);
  if (!root) return tl::make_unexpected(root.error());
  return Reader(path).read(*root);
}

}  // namespace gnomon::slb
