// SPDX-License-Identifier: Apache-2.0
// Register widths as functions of the parameters (docs/vpu.md, docs/number-formats.md).
#include <gnomon/golden/codec.hpp>
#include <stdexcept>

namespace gnomon::golden {

RegisterFormat register_format(Register reg, const HardwareConfig& config) {
  const int p = config.position_bits();
  const int f = config.matrix_frac_bits;
  const int d = config.depth_bits;
  const int plane = config.plane_log2;
  switch (reg) {
    case Register::MatrixUx:
      return {"MATRIX_UX", f + 2, true, f};
    case Register::MatrixUy:
      return {"MATRIX_UY", f + 2, true, f};
    case Register::MatrixUz:
      return {"MATRIX_UZ", f + 2, true, f};
    case Register::MatrixU1:
      return {"MATRIX_U1", f + p + 3, true, f};
    case Register::MatrixVx:
      return {"MATRIX_VX", f + 2, true, f};
    case Register::MatrixVy:
      return {"MATRIX_VY", f + 2, true, f};
    case Register::MatrixVz:
      return {"MATRIX_VZ", f + 2, true, f};
    case Register::MatrixV1:
      return {"MATRIX_V1", f + p + 3, true, f};
    case Register::MatrixDx:
      return {"MATRIX_DX", d + p + 2, true, p + 4};
    case Register::MatrixDy:
      return {"MATRIX_DY", d + p + 2, true, p + 4};
    case Register::MatrixDz:
      return {"MATRIX_DZ", d + p + 2, true, p + 4};
    case Register::MatrixD1:
      return {"MATRIX_D1", d + p + 8, true, p + 4};
    case Register::OffsetFactor:
      return {"OFFSET_FACTOR", 18, false, 16};
    case Register::FacingShift:
      return {"FACING_SHIFT", 6, false, 0};
    case Register::TiltShift:
      return {"TILT_SHIFT", 6, false, 0};
    case Register::DeltaShift:
      return {"DELTA_SHIFT", 6, false, 0};
    case Register::MarginSquared:
      return {"MARGIN_SQUARED", 24, false, 0};
    case Register::DeltaMax:
      return {"DELTA_MAX", d, false, 0};
    case Register::Projection:
      return {"PROJECTION", 2, false, 0};
    case Register::MatrixWx:
      return {"MATRIX_WX", f + 2, true, f + p};
    case Register::MatrixWy:
      return {"MATRIX_WY", f + 2, true, f + p};
    case Register::MatrixWz:
      return {"MATRIX_WZ", f + 2, true, f + p};
    case Register::MatrixW1:
      return {"MATRIX_W1", f + p + 3, true, f + p};
    case Register::WNear:
      return {"W_NEAR", p + 4, false, p};
    case Register::CentreU:
      return {"CENTRE_U", plane + 2, true, 0};
    case Register::CentreV:
      return {"CENTRE_V", plane + 2, true, 0};
    case Register::KeyLimit:
      return {"KEY_LIMIT", d + 8, false, 4};
    case Register::KeyScale:
      return {"KEY_SCALE", d + 8, false, 4};
    case Register::LightX:
      return {"LIGHT_X", p + 11, true, 3};
    case Register::LightY:
      return {"LIGHT_Y", p + 11, true, 3};
    case Register::LightZ:
      return {"LIGHT_Z", p + 11, true, 3};
    case Register::ConeSquared:
      return {"CONE_SQUARED", 2 * plane + 18, false, 16};
  }
  throw std::invalid_argument("register_format: no such register: " + std::to_string(static_cast<int>(reg)));
}

}  // namespace gnomon::golden
