// SPDX-License-Identifier: Apache-2.0
// A small set of hardware builds in which every pair of parameter values meets.
#pragma once

#include <gnomon/golden/config.hpp>
#include <vector>

namespace gnomon::stimulus {

/// Lowest, default and highest value of each parameter: every pair of values of one unit (DEPTH_BITS belongs
/// to both) that some legal build has occurs in at least one of the returned builds. All are legal; the order
/// is fixed, the first is the default build, the second the same with the silhouette-line buffer. The
/// buffer's plane goes up to 2^9 a side: memory, not logic, is what grows beyond.
std::vector<golden::HardwareConfig> covering_array();

/// Those with the silhouette-line buffer, ordered so that the first few meet many of its pairs of values.
std::vector<golden::HardwareConfig> slb_covering_array();
/// Planes of the silhouette-line buffer of 2^10, 2^11 and 2^12 a side, other parameters low, default and
/// high.
std::vector<golden::HardwareConfig> large_slb_configs();

/// Hardware with the frame buffer: every pair of grid size, fraction bits, layers and modes, in nine builds.
std::vector<golden::HardwareConfig> frame_covering_array();
/// A frame buffer for the default grid, with as many layers as there can be.
golden::HardwareConfig large_frame_config();

/// Every legal build of the projection unit with the values above, without the silhouette-line buffer.
std::vector<golden::HardwareConfig> corner_configs();
/// The same with topology mode: its own parameters in nine ways, which have every pair of their values.
std::vector<golden::HardwareConfig> topology_corner_configs();
/// Every legal silhouette-line buffer with the values above, beside a default projection unit of that depth.
std::vector<golden::HardwareConfig> slb_corner_configs();

}  // namespace gnomon::stimulus
