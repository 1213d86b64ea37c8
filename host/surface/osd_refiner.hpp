// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv's topology of a cage.
#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>

#include "host/surface/cage.hpp"

namespace gnomon::surface {

/// The unrefined topology, faces numbered as in the cage. Throws std::runtime_error where OpenSubdiv refuses
/// a cage that make_cage has accepted.
std::unique_ptr<OpenSubdiv::Far::TopologyRefiner> make_refiner(const Cage& cage);

}  // namespace gnomon::surface
