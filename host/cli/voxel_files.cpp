// SPDX-License-Identifier: Apache-2.0
// Voxel sets as files for other programs.
#include "host/cli/voxel_files.hpp"

#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <tbb/parallel_sort.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>

#include "host/pipeline/npy.hpp"

namespace gnomon::cli {

std::vector<std::array<std::int32_t, 3>> sorted_coordinates(const voxel::CoordinateSet& voxels) {
  std::vector<std::array<std::int32_t, 3>> rows;
  rows.reserve(voxels.voxels.size());
  for (const voxel::VoxelCoordinate& v : voxels.voxels) rows.push_back({v.x, v.y, v.z});
  tbb::parallel_sort(rows.begin(), rows.end());
  return rows;
}

nlohmann::ordered_json grid_json(const voxel::Grid& grid) {
  return {{"res", grid.res},
          {"origin", {grid.origin.x, grid.origin.y, grid.origin.z}},
          {"voxel_size", grid.voxel_size},
          {"adjacency", static_cast<int>(grid.adjacency)}};
}

Result<void> write_npy(const std::filesystem::path& path,
                       const std::vector<std::array<std::int32_t, 3>>& rows) {
  std::ofstream file(path, std::ios::binary);
  const std::string header = pipeline::npy_header(rows.size(), 3);
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  const auto bytes = std::as_bytes(std::span(rows));
  file.write(static_cast<const char*>(static_cast<const void*>(bytes.data())),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) return fail(std::strerror(errno));
  return {};
}

Result<void> write_vdb(const std::filesystem::path& path,
                       const std::vector<std::array<std::int32_t, 3>>& rows, const voxel::Grid& grid) {
  try {
    openvdb::initialize();
    const openvdb::FloatGrid::Ptr volume = openvdb::FloatGrid::create(0.0F);
    volume->setName("density");
    volume->setGridClass(openvdb::GRID_FOG_VOLUME);
    volume->setSaveFloatAsHalf(true);
    volume->insertMeta("res", openvdb::Int32Metadata(static_cast<std::int32_t>(grid.res)));
    volume->insertMeta("adjacency", openvdb::Int32Metadata(static_cast<std::int32_t>(grid.adjacency)));
    // OpenVDB's index i is a point: the voxel's centre.
    const Vec3 centre = grid.origin + Vec3(grid.voxel_size / 2);
    volume->setTransform(std::make_shared<openvdb::math::Transform>(openvdb::math::MapBase::Ptr(
        new openvdb::math::UniformScaleTranslateMap(grid.voxel_size, {centre.x, centre.y, centre.z}))));
    auto accessor = volume->getAccessor();
    for (const auto& [x, y, z] : rows) accessor.setValueOn({x, y, z}, 1.0F);
    openvdb::io::File file(path.string());
    file.write({volume});
    file.close();
  } catch (const openvdb::ArithmeticError&) {
    return fail(fmt::format("OpenVDB cannot hold voxels of size {:g}, expected 1e-4 or more: scale the model",
                            grid.voxel_size));
  } catch (const openvdb::IoError& error) {
    return fail(error.what());
  }
  return {};
}

}  // namespace gnomon::cli
