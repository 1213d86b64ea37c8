// SPDX-License-Identifier: Apache-2.0
// The image for the simulated processor, as this build has made it.
#pragma once

#include <cstdint>
#include <span>

namespace gnomon::firmware {

/// Bytes of program memory from address 0 on (docs/firmware.md).
std::span<const std::uint8_t> image();

}  // namespace gnomon::firmware
