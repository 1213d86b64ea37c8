// SPDX-License-Identifier: Apache-2.0
// OBJ files that cannot be meant, each with the line and the words that the message about it must have.
#pragma once

#include <string>
#include <vector>

namespace gnomon::test {

struct MalformedObj {
  std::string name;
  std::string text;
  int line;  ///< that the message names; 0: the file as a whole
  std::string words;
};

inline std::vector<MalformedObj> malformed_objs() {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";                  // lines 1 to 3
  const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";  // lines 1 to 5
  return {
      {"empty", "", 0, "no faces"},
      {"comments_only", "# nothing\n\n# here\n", 0, "no faces"},
      {"no_faces", triangle, 0, "no faces found (3 vertices)"},
      {"index_zero", triangle + "f 0 1 2\n", 4, "vertex index 0 is out of range, expected 1..3"},
      {"index_too_large", triangle + "f 1 2 9\n", 4, "vertex index 9 is out of range, expected 1..3"},
      {"index_too_large_second_face", triangle + "f 1 2 3\nf 1 2 4\n", 5, "vertex index 4 is out of range"},
      {"index_too_negative", triangle + "f 1 2 -4\n", 4, "vertex index -4 is out of range"},
      {"index_before_any_vertex", "f -1 -2 -3\n" + triangle, 1, "no vertex before"},
      {"index_beyond_32_bits", triangle + "f 1 2 99999999999\n", 4, "99999999999"},
      {"index_fraction", triangle + "f 1 2 2.5\n", 4, "malformed face corner '2.5'"},
      {"index_word", triangle + "f 1 2 three\n", 4, "malformed face corner 'three'"},
      {"corner_too_long", triangle + "f 1/1/1/1 2 3\n", 4, "malformed face corner '1/1/1/1'"},
      {"corner_texture_only", triangle + "f /1 2 3\n", 4, "malformed face corner '/1'"},
      {"corner_bad_normal", triangle + "f 1//x 2 3\n", 4, "malformed face corner '1//x'"},
      {"two_vertices", triangle + "f 1 2\n", 4, "face has 2 vertices, expected at least 3"},
      {"one_vertex", triangle + "f 1\n", 4, "face has 1 vertex"},
      {"no_vertices", triangle + "f\n", 4, "face has 0 vertices"},
      {"repeated_vertex", triangle + "f 1 2 2\n", 4, "vertex 2 more than once"},
      {"repeated_by_negative", triangle + "f 1 2 -2\n", 4, "vertex 2 more than once"},
      {"nan", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", 2, "'nan' is not finite"},
      {"negative_nan", "v 0 0 0\nv 0 -NaN 0\nv 0 1 0\nf 1 2 3\n", 2, "'-NaN' is not finite"},
      {"infinity", "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", 3, "'inf' is not finite"},
      {"microsoft_nan", "v 0 0 0\nv 1.#IND 0 0\nv 0 1 0\nf 1 2 3\n", 2, "'1.#IND' is not finite"},
      {"overflow", "v 0 0 0\nv 1e400 0 0\nv 0 1 0\nf 1 2 3\n", 2, "'1e400' is not finite"},
      {"huge", "v 0 0 0\nv 1e200 0 0\nv 0 1 0\nf 1 2 3\n", 2, "'1e200' is too large"},
      {"two_coordinates", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", 2, "vertex has 2 numbers"},
      {"no_coordinates", "v 0 0 0\nv\nv 0 1 0\nf 1 2 3\n", 2, "vertex has 0 numbers"},
      {"five_numbers", "v 0 0 0\nv 1 0 0 1 1\nv 0 1 0\nf 1 2 3\n", 2, "vertex has 5 numbers"},
      {"malformed_number", "v 0 0 0\nv 1 0x10 0\nv 0 1 0\nf 1 2 3\n", 2, "malformed number '0x10'"},
      {"number_with_comma", "v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n", 2, "malformed number '1,5'"},
      {"lone_point", "v 0 0 0\nv . 0 0\nv 0 1 0\nf 1 2 3\n", 2, "malformed number '.'"},
      {"lone_sign", "v 0 0 0\nv - 0 0\nv 0 1 0\nf 1 2 3\n", 2, "malformed number '-'"},
      {"empty_exponent", "v 0 0 0\nv 1e 0 0\nv 0 1 0\nf 1 2 3\n", 2, "malformed number '1e'"},
      {"one_point", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n", 0, "zero extent"},
      {"one_object_is_a_point", quad + "o dot\nv 5 5 5\nv 5 5 5\nv 5 5 5\nf 5 6 7\n", 0,
       "object 'dot' has zero extent"},
      {"unknown_statement", triangle + "solid cube\nf 1 2 3\n", 4, "unknown statement 'solid'"},
      {"misspelt_statement", triangle + "F 1 2 3\n", 4, "unknown statement 'F'"},
      {"binary",
       std::string("\x7f"
                   "ELF\x02\x01\x01\x00\x00\x00",
                   10),
       1, "binary data"},
      {"binary_after_text", triangle + std::string("f 1 2 3\0\0\n", 10), 4, "binary data"},
      {"tag_counts", quad + "t crease 2/1 0 1 2\n", 6, "malformed tag counts '2/1'"},
      {"tag_too_short", quad + "t crease 2/1/0 0 1\n", 6, "ends early"},
      {"tag_too_long", quad + "t crease 2/1/0 0 1 2 3\n", 6, "goes on with '3'"},
      {"tag_number", quad + "t crease 2/1/0 0 1 sharp\n", 6, "malformed number 'sharp'"},
      {"tag_without_name", quad + "t\n", 6, "malformed tag counts"},
      {"tag_unknown", quad + "t creese 2/1/0 0 1 2\n", 6, "unknown tag 'creese'"},
      {"tag_changes_surface", quad + "t creasemethod 0/0/1 chaikin\n", 6, "not supported"},
      {"crease_vertex", quad + "t crease 2/1/0 0 4 2\n", 6, "crease names vertex 4, expected 0..3"},
      {"crease_negative_vertex", quad + "t crease 2/1/0 -1 1 2\n", 6, "crease names vertex -1"},
      {"crease_no_edge", quad + "t crease 2/1/0 0 1 2\nt crease 2/1/0 0 2 2\n", 7, "no face has this edge"},
      {"crease_odd", quad + "t crease 3/1/0 0 1 2 2\n", 6, "pairs of vertices"},
      {"crease_negative", quad + "t crease 2/1/0 0 1 -2\n", 6, "sharpness -2 is out of range"},
      {"crease_nan", quad + "t crease 2/1/0 0 1 nan\n", 6, "sharpness nan is out of range"},
      {"corner_vertex", quad + "t corner 1/1/0 7 2\n", 6, "corner names vertex 7, expected 0..3"},
      {"corner_without_sharpness", quad + "t corner 1/0/0 1\n", 6, "one sharpness"},
      {"hole_face", quad + "t hole 1/0/0 1\n", 6, "hole names face 1, expected 0..0"},
      {"all_holes", quad + "t hole 1/0/0 0\n", 0, "every face is a hole"},
      {"boundary_rule", quad + "t interpolateboundary 1/0/0 3\n", 6,
       "0 (none), 1 (edge and corner) or 2 (edge only)"},
  };
}

}  // namespace gnomon::test
