// SPDX-License-Identifier: Apache-2.0
// The content of an OBJ file as it stands there.
#include "host/scene/obj_file.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <optional>
#include <span>
#include <streambuf>

#include "host/scene/text_lines.hpp"

namespace gnomon::scene {
namespace {

constexpr std::size_t kMostIndices = std::numeric_limits<std::int32_t>::max();

/// What tinyobjloader's callbacks fill, with the checks that need more than one line.
class Content {
 public:
  ObjFile file;

  void add_vertex(const Vec3& position, double weight) {
    if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z)) {
      return refuse("coordinate is not finite, expected a finite number");
    }
    if (file.positions.size() >= kMostIndices) return refuse("more than 2147483647 vertices");
    file.positions.push_back(position);
    if (has_weight && weight != 1) ++file.weighted_vertices;
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    const std::size_t first = file.face_indices.size();
    if (first + corners.size() > kMostIndices) return refuse("more than 2147483647 face corners");
    for (const tinyobj::index_t& corner : corners) {
      const std::optional<std::int32_t> vertex = resolve(corner.vertex_index);
      if (!vertex) return;
      file.face_indices.push_back(*vertex);
    }
    file.face_sizes.push_back(static_cast<std::int32_t>(corners.size()));
    check_repeated(std::span(file.face_indices).subspan(first));
  }

  void add_object(std::string name) {
    name.erase(name.find_last_not_of(" \t") + 1);
    if (!file.runs.empty() && file.runs.back().first_face == file.face_sizes.size()) file.runs.pop_back();
    file.runs.push_back({file.face_sizes.size(), std::move(name)});
  }

  /// Positive indices may point ahead; what never came is known at the end only.
  void finish() {
    for (const Ahead& ahead : ahead_) {
      if (static_cast<std::size_t>(ahead.vertex) < file.positions.size()) continue;
      line = ahead.line;
      return refuse(out_of_range(ahead.vertex + std::int64_t{1}));
    }
  }

  void refuse(std::string message) {
    if (!problem) problem = fmt::format("{}: error: {}", line, message);
  }

  bool has_weight = false;             ///< of the vertex being read: a colour looks the same to tinyobjloader
  std::size_t line = 0;                ///< of the statement being read
  std::optional<std::string> problem;  ///< the first fault, "line: error: ..."

 private:
  /// An index beyond the vertices read so far and beyond every one before it.
  struct Ahead {
    std::int32_t vertex;
    std::size_t line;
  };

  std::string out_of_range(std::int64_t index) const {
    return fmt::format("vertex index {} is out of range, expected 1..{} or -{}..-1", index,
                       file.positions.size(), file.positions.size());
  }

  std::optional<std::int32_t> resolve(int index) {
    const auto count = static_cast<std::int64_t>(file.positions.size());
    if (index == 0 || -std::int64_t{index} > count) {
      refuse(count > 0 ? out_of_range(index)
                       : fmt::format("vertex index {} is out of range, there is no vertex before this face",
                                     index));
      return std::nullopt;
    }
    if (index < 0) return static_cast<std::int32_t>(count + index);
    const std::int32_t vertex = index - 1;
    if (vertex >= count && (ahead_.empty() || vertex > ahead_.back().vertex))
      ahead_.push_back({vertex, line});
    return vertex;
  }

  void check_repeated(std::span<const std::int32_t> corners) {
    sorted_.assign(corners.begin(), corners.end());
    std::sort(sorted_.begin(), sorted_.end());
    const auto twin = std::adjacent_find(sorted_.begin(), sorted_.end());
    if (twin == sorted_.end()) return;
    refuse(fmt::format("face has vertex {} more than once, expected {} different vertices",
                       std::int64_t{*twin} + 1, corners.size()));
  }

  std::vector<Ahead> ahead_;
  std::vector<std::int32_t> sorted_;
};

/// Feeds tinyobjloader one checked statement at a time, so that in its callbacks `content.line` is the line
/// it reads.
class CheckedStatements : public std::streambuf {
 public:
  CheckedStatements(TextLines& lines, Content& content) : lines_(lines), content_(content) {}

 protected:
  int_type underflow() override {
    while (!content_.problem && lines_.next()) {
      content_.line = lines_.number();
      const Result<ObjStatement> kind = check_statement(lines_.text());
      if (!kind) {
        content_.refuse(kind.error().message);
      } else if (*kind == ObjStatement::Tag) {
        read_tag();
      } else if (*kind != ObjStatement::Blank && *kind != ObjStatement::Ignored) {
        content_.has_weight = *kind == ObjStatement::WeightedVertex;
        statement_ = *kind == ObjStatement::Object ? lines_.text() : without_comment(lines_.text());
        statement_ += '\n';
        setg(statement_.data(), statement_.data(), statement_.data() + statement_.size());
        return traits_type::to_int_type(statement_.front());
      }
    }
    return traits_type::eof();
  }

 private:
  // The streaming interface of tinyobjloader skips tags; its other one stops at faces of 255 corners.
  void read_tag() {
    Result<ObjTag> tag = parse_tag(lines_.text());
    if (!tag) return content_.refuse(tag.error().message);
    tag->line = content_.line;
    content_.file.tags.push_back(std::move(*tag));
  }

  TextLines& lines_;
  Content& content_;
  std::string statement_;
};

tinyobj::callback_t callbacks() {
  tinyobj::callback_t to;
  to.vertex_cb = [](void* content, double x, double y, double z, double w) {
    static_cast<Content*>(content)->add_vertex({x, y, z}, w);
  };
  to.index_cb = [](void* content, tinyobj::index_t* corners, int count) {
    static_cast<Content*>(content)->add_face({corners, static_cast<std::size_t>(count)});
  };
  to.object_cb = [](void* content, const char* name) { static_cast<Content*>(content)->add_object(name); };
  return to;
}

}  // namespace

Result<ObjFile> parse_obj_file(const std::filesystem::path& path) {
  Result<TextLines> lines = TextLines::open(path);
  if (!lines) return tl::make_unexpected(lines.error());
  Content content;
  CheckedStatements statements(*lines, content);
  std::istream stream(&statements);
  tinyobj::LoadObjWithCallback(stream, callbacks(), &content);
  if (!lines->read_error().empty()) return fail(path.string() + ": error: " + lines->read_error());
  content.finish();
  if (content.problem) return fail(path.string() + ":" + *content.problem);
  return std::move(content.file);
}

}  // namespace gnomon::scene
