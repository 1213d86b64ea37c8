// SPDX-License-Identifier: Apache-2.0
// Random commands for hardware with a frame buffer: passes of both modes that keep their states, and lookups.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <vector>

namespace gnomon::stimulus {

/// `commands` sound commands and a FENCE, from reset; the same for the same seed. `config` needs the frame
/// buffer; passes of a mode that it does not have are left out. Items crowd, so that voxels are written again
/// and lookups find them.
std::vector<golden::Word> frame_stream(const golden::HardwareConfig& config, std::uint64_t seed,
                                       int commands);

}  // namespace gnomon::stimulus
