// SPDX-License-Identifier: Apache-2.0
// What a statement of an OBJ file must look like. tinyobjloader reads nonsense as zero or drops it; nothing
// that does not pass here reaches it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::scene {

/// Larger coordinates are refused: their squares and cubes must stay finite.
inline constexpr double kLargestCoordinate = 1e90;

enum class ObjStatement : std::uint8_t { Blank, Vertex, WeightedVertex, Face, Object, Tag, Ignored };

/// Says what kind of statement `line` is and whether it is well formed. Errors carry no place: the caller
/// knows it. Ignored are the statements of the OBJ specification that a control cage does not need (vt, vn,
/// g, s, usemtl, l, ...).
Result<ObjStatement> check_statement(std::string_view line);

/// `line` without a trailing " # comment" (not for names, where # is a letter like any other).
std::string_view without_comment(std::string_view line);

/// One `t` statement, as OpenSubdiv's regression shapes write it: t name ints/floats/strings values...
struct ObjTag {
  std::string name;
  std::vector<std::int32_t> ints;
  std::vector<double> floats;
  std::vector<std::string> strings;
  std::size_t line = 0;
};
Result<ObjTag> parse_tag(std::string_view line);

}  // namespace gnomon::scene
