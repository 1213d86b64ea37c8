// SPDX-License-Identifier: Apache-2.0
// Set-up of the projection unit; its arithmetic is in the header, where the engine's loops can see it.
#include <gnomon/golden/vpu.hpp>

namespace gnomon::golden {

Vpu::Vpu(const HardwareConfig& config)
    : config_(config),
      position_bits_(config.position_bits()),
      matrix_frac_bits_(config.matrix_frac_bits),
      depth_frac_bits_(config.position_bits() + 4),
      plane_log2_(config.plane_log2),
      depth_max_((std::int64_t{1} << config.depth_bits) - 2) {}

void Vpu::set(Register reg, Word bits) {
  const RegisterFormat format = register_format(reg, config_);
  registers_[static_cast<std::size_t>(reg)] = format.is_signed
                                                  ? sign_extend(bits, format.width)
                                                  : static_cast<std::int64_t>(low_bits(bits, format.width));
}

}  // namespace gnomon::golden
