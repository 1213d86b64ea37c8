// SPDX-License-Identifier: Apache-2.0
// Legal combinations (docs/vpu-topology.md, "Parameters").
#include <gnomon/golden/topology/config.hpp>

namespace gnomon::golden::topology {
namespace {

std::optional<std::string> out_of_range(const char* name, int value, int low, int high) {
  if (value >= low && value <= high) return std::nullopt;
  return std::string(name) + "=" + std::to_string(value) + " is out of range " + std::to_string(low) + ".." +
         std::to_string(high);
}

}  // namespace

std::optional<std::string> TopologyConfig::check() const {
  if (auto error = out_of_range("VOXEL_BITS", voxel_bits, 4, 11)) return error;
  if (auto error = out_of_range("VOXEL_FRAC_BITS", voxel_frac_bits, 0, 6)) return error;
  if (auto error = out_of_range("NORMAL_BITS", normal_bits, 4, 12)) return error;
  if (auto error = out_of_range("MATRIX_FRAC_BITS", matrix_frac_bits, 12, 28)) return error;
  if (auto error = out_of_range("DEPTH_BITS", depth_bits, 8, 24)) return error;
  if (auto error = out_of_range("PLANE_LOG2", plane_log2, 4, 12)) return error;
  if (auto error = out_of_range("SUB_BITS", sub_bits, 2, 8)) return error;
  if (auto error = out_of_range("SPAN_LOG2", span_log2, 2, 6)) return error;
  if (auto error = out_of_range("NODES_LOG2", nodes_log2, 4, 24)) return error;
  if (auto error = out_of_range("QUADS_LOG2", quads_log2, 4, 24)) return error;
  // As for the projection unit as a whole: an item is one word, the matrix resolves a position.
  if (3 * (position_bits() + normal_bits) > 63)
    return "NORMAL_BITS=" + std::to_string(normal_bits) + " with " + std::to_string(position_bits()) +
           " position bits: 3 (P + N) exceeds 63";
  if (matrix_frac_bits < position_bits() + 2)
    return "MATRIX_FRAC_BITS=" + std::to_string(matrix_frac_bits) +
           " is below P + 2 = " + std::to_string(position_bits() + 2);
  return std::nullopt;
}

}  // namespace gnomon::golden::topology
