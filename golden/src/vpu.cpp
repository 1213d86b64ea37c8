// SPDX-License-Identifier: Apache-2.0
// Set-up of the projection unit; its arithmetic is in the header, where the engine's loops can see it.
#include <gnomon/golden/vpu.hpp>

namespace gnomon::golden {

Vpu::Vpu(const HardwareConfig& config)
    : config_(config),
      light_({.position_bits = config.position_bits(),
              .matrix_frac_bits = config.matrix_frac_bits,
              .depth_bits = config.depth_bits,
              .plane_log2 = config.plane_log2},
             {}),
      position_bits_(config.position_bits()),
      matrix_frac_bits_(config.matrix_frac_bits),
      depth_frac_bits_(config.position_bits() + 4),
      plane_log2_(config.plane_log2),
      depth_max_((std::int64_t{1} << config.depth_bits) - 2) {}

void Vpu::set(Register reg, Word bits) {
  const RegisterFormat format = register_format(reg, config_);
  const std::int64_t value = format.is_signed ? sign_extend(bits, format.width)
                                              : static_cast<std::int64_t>(low_bits(bits, format.width));
  registers_[static_cast<std::size_t>(reg)] = value;
  if (reg >= Register::Projection) set_light(reg, value);
}

void Vpu::set_light(Register reg, std::int64_t value) {
  perspective::Registers& light = light_.registers();
  const auto from = [reg](Register first) {
    return static_cast<std::size_t>(reg) - static_cast<std::size_t>(first);
  };
  switch (reg) {
    case Register::Projection:
      light.perspective = (value & kProjectionPerspective) != 0;
      light.cone = (value & kProjectionCone) != 0;
      break;
    case Register::MatrixWx:
    case Register::MatrixWy:
    case Register::MatrixWz:
    case Register::MatrixW1:
      light.w[from(Register::MatrixWx)] = value;
      break;
    case Register::WNear:
      light.w_near = value;
      break;
    case Register::CentreU:
    case Register::CentreV:
      light.centre[from(Register::CentreU)] = value;
      break;
    case Register::KeyLimit:
      light.key_limit = value;
      break;
    case Register::KeyScale:
      light.key_scale = value;
      break;
    case Register::LightX:
    case Register::LightY:
    case Register::LightZ:
      light.light[from(Register::LightX)] = value;
      break;
    case Register::ConeSquared:
      light.cone_squared = value;
      break;
    default:
      break;  // of both projections
  }
}

}  // namespace gnomon::golden
