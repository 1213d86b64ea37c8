// SPDX-License-Identifier: Apache-2.0
// The definition of what the hardware answers: integer arithmetic from docs/vpu.md, one command after the
// other.
#pragma once

#include <gnomon/golden/engine.hpp>
#include <memory>

namespace gnomon::golden {

/// `config` must pass check(); throws std::invalid_argument otherwise.
std::unique_ptr<Engine> make_golden_engine(const HardwareConfig& config);

}  // namespace gnomon::golden
