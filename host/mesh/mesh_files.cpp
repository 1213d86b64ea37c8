// SPDX-License-Identifier: Apache-2.0
// Text and bytes, a few megabytes at a time.
#include "host/mesh/mesh_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace gnomon::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

/// What has been written so far, on its way to the file.
class Sink {
 public:
  Sink(const std::filesystem::path& path, const std::function<void()>& poll)
      : file_(path, std::ios::binary), poll_(poll) {}

  template <class... Values>
  void text(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    flush_if_full();
  }
  template <class T>
  void bytes(const T& value) {
    const auto* begin = static_cast<const char*>(static_cast<const void*>(&value));
    buffer_.append(begin, begin + sizeof value);
    flush_if_full();
  }
  Result<void> finish() {
    flush();
    file_.close();
    if (!file_) return fail(std::strerror(errno));
    return {};
  }

 private:
  static constexpr std::size_t kFull = 1U << 22;
  void flush_if_full() {
    if (buffer_.size() >= kFull) flush();
  }
  void flush() {
    if (poll_) poll_();
    file_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ofstream file_;
  const std::function<void()>& poll_;
  fmt::memory_buffer buffer_;
};

/// Significant digits that tell points a thousandth of a voxel apart.
int digits(const SurfaceMesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions)
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  const double ratio = std::max(1.0, largest / mesh.spacing);
  return std::min(17, static_cast<int>(std::ceil(std::log10(ratio))) + 4);
}

/// White space would end the name.
std::string one_word(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }, '_');
  return name.empty() ? "object" : name;
}

void write_obj_face(Sink& sink, const Corners& vertices, const Corners& normals) {
  sink.text("f");
  for (std::size_t k = 0; k < corner_count(vertices); ++k)
    sink.text(" {}//{}", std::uint64_t{vertices[k]} + 1, std::uint64_t{normals[k]} + 1);
  sink.text("\n");
}

void write_ply_header(Sink& sink, const SurfaceMesh& mesh, std::size_t lights) {
  sink.text("ply\nformat binary_little_endian 1.0\ncomment gnomon: subpatches of limit surfaces\n");
  sink.text("element vertex {}\n", mesh.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) sink.text("property float {}\n", name);
  for (std::size_t i = 0; i < lights; ++i) sink.text("property uchar shadow_{}\n", i);
  sink.text("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.faces.size());
}

}  // namespace

Result<MeshFormat> mesh_format(const std::filesystem::path& path) {
  if (path.extension() == ".obj") return MeshFormat::Obj;
  if (path.extension() == ".ply") return MeshFormat::Ply;
  return fail(path.string() + ": error: expected a name that ends in .obj or .ply");
}

Result<void> write_obj(const std::filesystem::path& path, const SurfaceMesh& mesh,
                       const std::function<void()>& poll) {
  Sink sink(path, poll);
  const int precision = digits(mesh);
  sink.text("# gnomon: subpatches of limit surfaces\n");
  for (const Vec3& p : mesh.positions)
    sink.text("v {:.{}g} {:.{}g} {:.{}g}\n", p.x, precision, p.y, precision, p.z, precision);
  for (const auto& n : mesh.normals) sink.text("vn {:.5f} {:.5f} {:.5f}\n", n[0], n[1], n[2]);
  for (std::size_t i = 0; i < mesh.objects.size(); ++i) {
    sink.text("o {}\n", one_word(mesh.objects[i].name));
    const std::size_t end = i + 1 < mesh.objects.size() ? mesh.objects[i + 1].first_face : mesh.faces.size();
    for (std::size_t f = mesh.objects[i].first_face; f < end; ++f)
      write_obj_face(sink, mesh.faces[f], mesh.face_normals[f]);
  }
  return sink.finish();
}

Result<void> write_ply(const std::filesystem::path& path, const SurfaceMesh& mesh,
                       std::span<const VertexShadows> lights, const std::function<void()>& poll) {
  Sink sink(path, poll);
  write_ply_header(sink, mesh, lights.size());
  const std::vector<std::array<float, 3>> normals = vertex_normals(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& p = mesh.positions[i];
    sink.bytes(std::array{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    sink.bytes(normals[i]);
    for (const VertexShadows& light : lights) sink.bytes(light.at(i));
  }
  for (const Corners& face : mesh.faces) {
    const std::size_t count = corner_count(face);
    sink.bytes(static_cast<std::uint8_t>(count));
    for (std::size_t k = 0; k < count; ++k) sink.bytes(static_cast<std::int32_t>(face[k]));
  }
  return sink.finish();
}

Result<void> write_mesh(MeshFormat format, const std::filesystem::path& path, const SurfaceMesh& mesh,
                        std::span<const VertexShadows> lights, const std::function<void()>& poll) {
  return format == MeshFormat::Obj ? write_obj(path, mesh, poll) : write_ply(path, mesh, lights, poll);
}

}  // namespace gnomon::mesh
