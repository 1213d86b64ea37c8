// SPDX-License-Identifier: Apache-2.0
// Widths follow from the largest magnitudes of registers and items; docs/number-formats.md derives them.
#include <algorithm>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/formats.hpp>

namespace gnomon::golden {
namespace {

void add_registers(std::vector<ValueFormat>& formats, int first, int last, const HardwareConfig& config) {
  for (int i = first; i < last; ++i) {
    const RegisterFormat reg = register_format(static_cast<Register>(i), config);
    formats.push_back({reg.name, reg.width, reg.is_signed, reg.frac_bits});
  }
}

/// Of docs/vpu.md, "Perspective", and of the beam of docs/vpu-topology.md.
void add_perspective(std::vector<ValueFormat>& formats, const HardwareConfig& config) {
  const int p = config.position_bits(), n = config.normal_bits;
  const int f = config.matrix_frac_bits, d = config.depth_bits, plane = config.plane_log2;
  add_registers(formats, kRegisterCount, kAllRegisterCount, config);
  const std::vector<ValueFormat> values = {
      {"w_acc", f + p + 5, true, f + p},
      {"w_high", p + 5, true, p},
      {"k", 5, false, 0},
      {"m", 24, false, 23},
      {"seed", 16, false, 16},
      {"t", 25, false, 24},
      {"r", 24, false, 24},
      {"q_u", plane + 16, true, 12},
      {"x_u", plane + 16, true, 12},
      {"u_fine", plane + 17, true, 12},
      {"h", d + 8, false, 4},
      {"key", d + 9, true, 4},
      {"b", p + 12, true, 3},
      {"g_d_from_light", p + n + 13, true, n + 2},
      {"g_w", f + n + 3, true, f + p},
      {"cone_sum", 2 * plane + 24, false, 16},
      {"w_step_product", f + n + 21, true, f + p + 16},
      {"w_step", f + n + 5, true, f + p},
      {"q_du", plane + 16, true, 12},
      {"q_dw", 22, true, 20},
      {"x_du", plane + 16, true, 12},
      {"rho", 22, true, 20},
      {"x_turn", plane + 18, true, 12},
      {"u_moved_fine", plane + 19, true, 12},
      {"h_step", d + 10, true, 4},
      {"key_moved", d + 11, true, 4},
      {"delta_limit", d + 4, false, 0},
      {"q_c", 21, false, 20},
      {"rho_c", 21, false, 20},
      {"rho_a", 23, true, 20},
      {"a_step", d + 11, true, 4},
      {"key_a", d + 12, true, 4},
  };
  formats.insert(formats.end(), values.begin(), values.end());
}

}  // namespace

std::vector<ValueFormat> value_formats(const HardwareConfig& config) {
  const int p = config.position_bits(), n = config.normal_bits;
  const int f = config.matrix_frac_bits, d = config.depth_bits;
  const int wider = std::max(p, n);
  std::vector<ValueFormat> formats = {
      {"position", p, false, config.voxel_frac_bits},
      {"normal", n, true, n - 1},
  };
  add_registers(formats, 0, kRegisterCount, config);
  const std::vector<ValueFormat> results = {
      {"u_acc", f + p + 5, true, f},
      {"u", p + 5, true, 0},
      {"d_acc", d + 2 * p + 6, true, p + 4},
      {"d_floor", d + p + 2, true, 0},
      {"d", d, false, 0},
      {"g_u", f + n + 3, true, f},
      {"g_d", d + p + n + 3, true, p + 4},
      {"u_step_product", f + n + 21, true, f + 16},
      {"u_step", f + n + 5, true, f},
      {"u_moved_acc", f + wider + 6, true, f},
      {"u_moved", wider + 6, true, 0},
      {"g_d_coarse", d + n + 3, true, 4},
      {"d_step_product", d + n + 21, true, 20},
      {"d_step", d + n + 5, true, 4},
      {"d_coarse", d + p + 6, true, 4},
      {"d_moved_acc", d + std::max(p + 1, n) + 6, true, 4},
      {"d_moved_floor", d + std::max(p + 1, n) + 2, true, 0},
      {"d_moved", d, false, 0},
      {"delta_signed", d + 1, true, 0},
      {"delta", d, false, 0},
      {"delta_n", 12, false, 0},
      {"g_dn", 16, false, 0},
      {"g_un", 16, false, 0},
      {"margin_left_root", 28, false, 0},
      {"margin_left", 56, false, 0},
      {"tilt_squared", 33, false, 0},
      {"margin_right", 57, false, 0},
  };
  formats.insert(formats.end(), results.begin(), results.end());
  add_perspective(formats, config);
  return formats;
}

}  // namespace gnomon::golden
