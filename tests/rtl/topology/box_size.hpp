// SPDX-License-Identifier: Apache-2.0
// How much of the plane a quad's box takes up: as many cycles, and as many nodes or drops.
#pragma once

#include <gnomon/golden/topology/codec.hpp>
#include <span>

#include "tests/rtl/topology/outcome.hpp"

namespace gnomon::rtl_test::topology {

/// Entries of the plane that the box of these four corners meets under a light.
std::int64_t box_size(std::span<const Word, golden::topology::kWordsPerQuad> corners,
                      const ProjectionRegisters& light, const TopologyConfig& config);

}  // namespace gnomon::rtl_test::topology
