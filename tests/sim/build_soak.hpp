// SPDX-License-Identifier: Apache-2.0
// Co-simulation of builds that are too many to compile in every check.
#pragma once

#include <cstdint>

namespace gnomon::sim::test {

/// Every build of the covering arrays with the silhouette-line buffer or the frame buffer, and large planes
/// of the former: directed and random streams with all ways of holding back the ports, each build with
/// latencies, stalls and dividers of its own. Starts with build number `first`, from 1. Prints a
/// line a build. Returns the number of builds that failed
/// or compared too little.
int soak_builds(std::uint64_t first);

}  // namespace gnomon::sim::test
