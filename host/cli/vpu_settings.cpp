// SPDX-License-Identifier: Apache-2.0
// The parameters of the projection unit, as the planner takes them.
#include "host/cli/vpu_settings.hpp"

#include <bit>

namespace gnomon::cli {

plan::VpuSettings vpu_settings(const config::Settings& settings) {
  const auto integer = [&](std::string_view key) { return static_cast<int>(settings.integer(key)); };
  plan::VpuSettings vpu;
  vpu.pitch = settings.number("pitch");
  vpu.offset_factor = settings.number("offset");
  vpu.margin = settings.number("margin");
  vpu.margin_tan_max = settings.number("margin_tan_max");
  // The registry takes 0 and powers of two only.
  const auto plane = static_cast<unsigned>(integer("plane"));
  vpu.plane_log2 = plane == 0 ? 0 : std::countr_zero(plane);
  vpu.voxel_frac_bits = integer("voxel_frac_bits");
  vpu.normal_bits = integer("normal_bits");
  vpu.matrix_frac_bits = integer("matrix_frac_bits");
  vpu.depth_bits = integer("depth_bits");
  return vpu;
}

}  // namespace gnomon::cli
