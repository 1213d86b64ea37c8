// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/cases.hpp"

#include "tests/support/voxel_patterns.hpp"

namespace gnomon::golden_test {

using golden::HardwareConfig;
using golden::Register;
using stimulus::Random;
using stimulus::RegisterValues;

HardwareConfig any_config(Random& random, int max_plane_log2) {
  const auto between = [&](int low, int high) { return static_cast<int>(random.between(low, high)); };
  while (true) {
    HardwareConfig config;
    config.voxel_bits = between(4, 11);
    config.voxel_frac_bits = between(0, 6);
    config.normal_bits = between(4, 12);
    config.matrix_frac_bits = between(12, 28);
    config.depth_bits = between(8, 24);
    config.plane_log2 = between(4, max_plane_log2);
    if (!config.check()) return config;
  }
}

RegisterValues any_registers(const HardwareConfig& config, Content content, Random& random) {
  const RegisterValues extreme = stimulus::extreme_registers(config, random);
  if (content == Content::Extreme) return extreme;
  RegisterValues values = stimulus::scene_registers(config, random);
  if (content == Content::Scene) return values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (random.chance(15)) values[i] = extreme[i];
  }
  return values;
}

Case any_case(std::uint64_t seed, Content content, std::size_t count) {
  Random random(seed);
  Case result;
  result.config = any_config(random, 7);
  result.registers = any_registers(result.config, content, random);
  const auto pattern = static_cast<stimulus::Pattern>(random.between(0, stimulus::kPatternCount - 1));
  result.items = stimulus::voxel_pattern(pattern, count, result.registers, result.config, random);
  return result;
}

golden::Vpu make_vpu(const HardwareConfig& config, const RegisterValues& registers) {
  golden::Vpu vpu(config);
  for (std::size_t i = 0; i < registers.size(); ++i) {
    vpu.set(static_cast<Register>(i), static_cast<golden::Word>(registers[i]));
  }
  return vpu;
}

}  // namespace gnomon::golden_test
