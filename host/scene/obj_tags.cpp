// SPDX-License-Identifier: Apache-2.0
// The meaning of OpenSubdiv's `t` statements.
#include "host/scene/obj_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace gnomon::scene {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

Edge edge_of(std::int32_t a, std::int32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

class Interpreter {
 public:
  explicit Interpreter(const ObjFile& file) : file_(file) {}

  Result<void> take(const ObjTag& tag) {
    if (tag.name == "crease") return take_crease(tag);
    if (tag.name == "corner") return take_corner(tag);
    if (tag.name == "hole") return take_hole(tag);
    if (tag.name == "interpolateboundary") return take_boundary(tag);
    return take_other(tag);
  }

  /// Creases wait until all of a file's tags are known: one pass over the faces then tells which edges exist.
  Result<ObjTags> finish(const std::filesystem::path& path) {
    std::map<Edge, std::size_t> missing = crease_line_;
    std::size_t first = 0;
    for (const std::int32_t face_size : file_.face_sizes) {
      const auto size = static_cast<std::size_t>(face_size);
      for (std::size_t i = 0; i < size && !missing.empty(); ++i) {
        missing.erase(edge_of(file_.face_indices[first + i], file_.face_indices[first + (i + 1) % size]));
      }
      first += size;
    }
    const auto earliest = std::min_element(missing.begin(), missing.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
    if (earliest != missing.end()) {
      return fail(fmt::format("{}:{}: error: crease from vertex {} to {} (0-based): no face has this edge",
                              path.string(), earliest->second, earliest->first.first,
                              earliest->first.second));
    }
    std::sort(tags_.holes.begin(), tags_.holes.end());
    tags_.holes.erase(std::unique(tags_.holes.begin(), tags_.holes.end()), tags_.holes.end());
    if (tags_.holes.size() == file_.face_sizes.size()) {
      return fail(fmt::format("{}: error: every face is a hole, expected a surface", path.string()));
    }
    return std::move(tags_);
  }

 private:
  Result<float> sharpness(const ObjTag& tag, std::size_t i) const {
    const double value = tag.floats.size() == 1 ? tag.floats[0] : tag.floats[i];
    if (std::isnan(value) || value < 0) {
      return fail(
          fmt::format("{} sharpness {:g} is out of range, expected 0 (smooth) to 10 (infinitely sharp)",
                      tag.name, value));
    }
    return static_cast<float>(std::min(value, 10.0));
  }

  Result<void> check_vertex(const ObjTag& tag, std::int32_t v) const {
    if (v >= 0 && static_cast<std::size_t>(v) < file_.positions.size()) return {};
    return fail(fmt::format("{} names vertex {}, expected 0..{} (tags count from 0)", tag.name, v,
                            static_cast<std::ptrdiff_t>(file_.positions.size()) - 1));
  }

  Result<void> take_crease(const ObjTag& tag) {
    const std::size_t edges = tag.ints.size() / 2;
    if (edges == 0 || tag.ints.size() % 2 != 0 || (tag.floats.size() != 1 && tag.floats.size() != edges)) {
      return fail(fmt::format(
          "crease has {} vertices and {} sharpnesses, expected pairs of vertices and one sharpness "
          "(or one a pair)",
          tag.ints.size(), tag.floats.size()));
    }
    for (std::size_t i = 0; i < edges; ++i) {
      const std::int32_t a = tag.ints[2 * i], b = tag.ints[2 * i + 1];
      for (const std::int32_t v : {a, b}) {
        if (Result<void> known = check_vertex(tag, v); !known) return known;
      }
      const Result<float> sharp = sharpness(tag, i);
      if (!sharp) return tl::make_unexpected(sharp.error());
      tags_.creases.push_back({a, b, *sharp});
      crease_line_.try_emplace(edge_of(a, b), tag.line);
    }
    return {};
  }

  Result<void> take_corner(const ObjTag& tag) {
    if (tag.ints.empty() || (tag.floats.size() != 1 && tag.floats.size() != tag.ints.size())) {
      return fail(
          fmt::format("corner has {} vertices and {} sharpnesses, expected one sharpness (or one a vertex)",
                      tag.ints.size(), tag.floats.size()));
    }
    for (std::size_t i = 0; i < tag.ints.size(); ++i) {
      if (Result<void> known = check_vertex(tag, tag.ints[i]); !known) return known;
      const Result<float> sharp = sharpness(tag, i);
      if (!sharp) return tl::make_unexpected(sharp.error());
      tags_.corners.push_back({tag.ints[i], *sharp});
    }
    return {};
  }

  Result<void> take_hole(const ObjTag& tag) {
    for (const std::int32_t face : tag.ints) {
      if (face < 0 || static_cast<std::size_t>(face) >= file_.face_sizes.size()) {
        return fail(fmt::format("hole names face {}, expected 0..{} (tags count from 0)", face,
                                static_cast<std::ptrdiff_t>(file_.face_sizes.size()) - 1));
      }
      tags_.holes.push_back(face);
    }
    return {};
  }

  Result<void> take_boundary(const ObjTag& tag) {
    // The order is OpenSubdiv's regression format's, not that of its enumeration.
    static constexpr std::array kRules{Boundary::None, Boundary::EdgeAndCorner, Boundary::EdgeOnly};
    if (tag.ints.size() != 1 || tag.ints[0] < 0 || static_cast<std::size_t>(tag.ints[0]) >= kRules.size()) {
      return fail("interpolateboundary takes one integer: 0 (none), 1 (edge and corner) or 2 (edge only)");
    }
    tags_.boundary = kRules[static_cast<std::size_t>(tag.ints[0])];
    return {};
  }

  Result<void> take_other(const ObjTag& tag) {
    // These say something about texture coordinates alone.
    if (tag.name.starts_with("facevarying")) return {};
    const std::string value = tag.strings.empty() ? "" : tag.strings[0];
    if ((tag.name == "creasemethod" && value == "normal") ||
        (tag.name == "smoothtriangles" && value == "catmark")) {
      return {};
    }
    if (tag.name == "creasemethod" || tag.name == "smoothtriangles" || tag.name == "vertexedit" ||
        tag.name == "edgeedit" || tag.name == "faceedit") {
      return fail(fmt::format("tag '{}{}{}' would change the surface and is not supported", tag.name,
                              value.empty() ? "" : " ", value));
    }
    return fail(
        fmt::format("unknown tag '{}', expected crease, corner, hole or interpolateboundary", tag.name));
  }

  const ObjFile& file_;
  ObjTags tags_;
  std::map<Edge, std::size_t> crease_line_;
};

}  // namespace

Result<ObjTags> interpret_tags(const std::filesystem::path& path, const ObjFile& file) {
  Interpreter interpreter(file);
  for (const ObjTag& tag : file.tags) {
    if (Result<void> taken = interpreter.take(tag); !taken) {
      return fail(fmt::format("{}:{}: error: {}", path.string(), tag.line, taken.error().message));
    }
  }
  return interpreter.finish(path);
}

}  // namespace gnomon::scene
