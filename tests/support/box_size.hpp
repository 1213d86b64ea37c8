// SPDX-License-Identifier: Apache-2.0
// How much of the plane a quad's box takes up: as many cycles, and as many nodes or drops.
#pragma once

#include <gnomon/golden/topology/unit.hpp>
#include <span>

namespace gnomon::stimulus {

/// Entries of the plane that the box of these four corners meets under a light.
std::int64_t box_size(std::span<const golden::topology::Word, golden::topology::kWordsPerQuad> corners,
                      const golden::topology::ProjectionRegisters& light,
                      const golden::topology::TopologyConfig& config);

}  // namespace gnomon::stimulus
