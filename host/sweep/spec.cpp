// SPDX-License-Identifier: Apache-2.0
// Reading a sweep's specification.
#include "host/sweep/spec.hpp"

#include <fmt/format.h>

#include "sim/content_hash.hpp"

namespace gnomon::sweep {
namespace {

using config::Document;
using Pointer = Document::Pointer;

bool has(const Document& document, const char* key) {
  return document.root().contains(key);
}

Result<void> expect_table(const Document& document, const Pointer& at) {
  if (!document.root().at(at).is_object()) return document.refuse(at, "expected a table");
  return {};
}

Result<std::vector<std::filesystem::path>> read_scenes(const Document& document) {
  const Pointer at("/scenes");
  if (!has(document, "scenes")) return document.refuse(Pointer(), "has no 'scenes'");
  const nlohmann::json& list = document.root().at(at);
  if (!list.is_array() || list.empty()) return document.refuse(at, "expected a list of files");
  std::vector<std::filesystem::path> scenes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_string()) return document.refuse(at / i, "expected the name of a file");
    scenes.push_back((document.path().parent_path() / list[i].get<std::string>()).lexically_normal());
  }
  return scenes;
}

Result<Assignments> read_assignments(const Document& document, const Pointer& at) {
  if (auto table = expect_table(document, at); !table) return tl::make_unexpected(table.error());
  Assignments assignments;
  for (const auto& [key, value] : document.root().at(at).items()) {
    Result<std::string> text = read_value(document, at / key, key);
    if (!text) return tl::make_unexpected(text.error());
    assignments.emplace(key, std::move(*text));
  }
  return assignments;
}

Result<std::vector<Axis>> read_axes(const Document& document, const Assignments& fixed) {
  const Pointer at("/axes");
  if (auto table = expect_table(document, at); !table) return tl::make_unexpected(table.error());
  std::vector<Axis> axes;
  for (const auto& [key, value] : document.root().at(at).items()) {
    if (fixed.contains(key))
      return document.refuse(at / key, fmt::format("{} stands in [fixed] as well", key));
    Result<Axis> axis = read_axis(document, at / key, key);
    if (!axis) return tl::make_unexpected(axis.error());
    axes.push_back(std::move(*axis));
  }
  return axes;
}

Result<Sample> read_sample(const Document& document) {
  const Pointer at("/sample");
  if (auto table = expect_table(document, at); !table) return tl::make_unexpected(table.error());
  if (auto known = document.check_keys(at, {"method", "points", "seed"}); !known)
    return tl::make_unexpected(known.error());
  const nlohmann::json& table = document.root().at(at);
  Sample sample;
  const nlohmann::json method = table.value("method", nlohmann::json("grid"));
  if (method == "random") {
    sample.method = Method::Random;
  } else if (method == "latin-hypercube") {
    sample.method = Method::LatinHypercube;
  } else if (method != "grid") {
    return document.refuse(at / "method", "expected \"grid\", \"random\" or \"latin-hypercube\"");
  }
  if (table.contains("points")) {
    const nlohmann::json& points = table.at("points");
    if (!points.is_number_integer() || points.get<std::int64_t>() < 1 ||
        points.get<std::int64_t>() > 10000000)
      return document.refuse(at / "points", "expected a whole number, 1..10000000");
    if (sample.method == Method::Grid)
      return document.refuse(at / "points", "a grid has as many points as its axes make");
    sample.points = points.get<std::size_t>();
  } else if (sample.method != Method::Grid) {
    return document.refuse(at, "has no 'points'");
  }
  if (table.contains("seed")) {
    if (!table.at("seed").is_number_integer() || table.at("seed").get<std::int64_t>() < 0)
      return document.refuse(at / "seed", "expected a whole number");
    sample.seed = table.at("seed").get<std::uint64_t>();
  }
  return sample;
}

Result<std::vector<Assignments>> read_list(const Document& document) {
  const Pointer at("/list");
  const nlohmann::json& entries = document.root().at(at);
  if (!entries.is_array()) return document.refuse(at, "expected a list of tables");
  std::vector<Assignments> list;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    Result<Assignments> assignments = read_assignments(document, at / i);
    if (!assignments) return tl::make_unexpected(assignments.error());
    list.push_back(std::move(*assignments));
  }
  return list;
}

Result<std::vector<std::string>> read_constraints(const Document& document) {
  const Pointer at("/constraints");
  const nlohmann::json& entries = document.root().at(at);
  if (!entries.is_array()) return document.refuse(at, "expected a list of expressions");
  std::vector<std::string> constraints;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!entries[i].is_string()) return document.refuse(at / i, "expected an expression");
    if (const auto parsed = Constraint::parse(entries[i].get<std::string>()); !parsed)
      return document.refuse(at / i, parsed.error().message);
    constraints.push_back(entries[i].get<std::string>());
  }
  return constraints;
}

/// Reads one part of the file into a member, if the file has it.
template <class T>
Result<void> take(T& member, Result<T> read) {
  if (!read) return tl::make_unexpected(read.error());
  member = std::move(*read);
  return {};
}

Result<void> read_parts(const Document& document, Spec& spec) {
  if (auto done = take(spec.scenes, read_scenes(document)); !done) return done;
  if (has(document, "fixed")) {
    if (auto done = take(spec.fixed, read_assignments(document, Pointer("/fixed"))); !done) return done;
  }
  if (has(document, "axes")) {
    if (auto done = take(spec.axes, read_axes(document, spec.fixed)); !done) return done;
  }
  if (has(document, "list")) {
    if (auto done = take(spec.list, read_list(document)); !done) return done;
  }
  if (has(document, "sample")) {
    if (auto done = take(spec.sample, read_sample(document)); !done) return done;
  }
  if (has(document, "constraints")) {
    if (auto done = take(spec.constraints, read_constraints(document)); !done) return done;
  }
  if (spec.axes.empty() && spec.list.empty())
    return document.refuse(Pointer(), "has no points: expected [axes] or [[list]]");
  return {};
}

}  // namespace

Result<Spec> read_spec(const std::filesystem::path& path) {
  const Result<Document> document = Document::read(path);
  if (!document) return tl::make_unexpected(document.error());
  if (auto known = document->check_keys(Pointer(),
                                        {"name", "scenes", "fixed", "axes", "sample", "constraints", "list"});
      !known)
    return tl::make_unexpected(known.error());
  Spec spec;
  spec.name = path.stem().string();
  if (has(*document, "name")) {
    const nlohmann::json& name = document->root().at("name");
    if (!name.is_string()) return document->refuse(Pointer("/name"), "expected a text");
    spec.name = name.get<std::string>();
  }
  spec.text = sim::read_file(path);
  if (auto done = read_parts(*document, spec); !done) return tl::make_unexpected(done.error());
  return spec;
}

}  // namespace gnomon::sweep
