// SPDX-License-Identifier: Apache-2.0
// Register contents of the perspective projection for tests: like a host would set them, and like nobody
// would.
#pragma once

#include <array>
#include <gnomon/golden/topology/unit.hpp>

#include "tests/support/scene_registers.hpp"

namespace gnomon::stimulus {

using AllRegisters = std::array<std::int64_t, golden::kAllRegisterCount>;

/// A spot or a face of a point light inside the grid, beside it or far away, looking at the grid's middle;
/// now and then with voxels behind it or too near.
AllRegisters perspective_registers(const golden::HardwareConfig& config, Random& random);

/// As perspective_registers, with some registers at their ends (`percent` of them). PERSPECTIVE stays set.
AllRegisters extreme_perspective_registers(const golden::HardwareConfig& config, int percent, Random& random);

/// Those that voxel_pattern needs: the light's axis in the place of the d row, so that columns stand along
/// it.
RegisterValues pattern_registers(const AllRegisters& registers, const golden::HardwareConfig& config);

/// What topology mode reads of them.
golden::topology::ProjectionRegisters projection_registers(const AllRegisters& registers,
                                                           const golden::HardwareConfig& config);

}  // namespace gnomon::stimulus
