// SPDX-License-Identifier: Apache-2.0
// Command streams for the silhouette-line buffer that end by showing everything it holds.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <vector>

namespace gnomon::rtl_test {

/// Random objects, queries and errors (tests/golden/slb), then a FENCE and every entry of the plane.
std::vector<golden::Word> random_slb_stream(std::uint64_t seed, const golden::HardwareConfig& config);

/// Many small objects, flat and not, one over the other in a few pixels, so that entries overflow whatever
/// they hold, with samples of COVER in every pixel after each; queries all over; then as above.
std::vector<golden::Word> crowded_slb_stream(std::uint64_t seed, const golden::HardwareConfig& config);

/// Large objects, flat and not, on the plane, beside it and around it, with holes, and a sample of COVER in
/// every pixel after each; then as above.
std::vector<golden::Word> wide_slb_stream(std::uint64_t seed, const golden::HardwareConfig& config);

/// 150 polygons one on the other in one object, reaching off the plane to the left, in either sense: sums of
/// winding numbers and of corners saturate. Then as above.
std::vector<golden::Word> piled_slb_stream(std::uint64_t seed, const golden::HardwareConfig& config);

/// A diamond with its corners on the grid, and points exactly on its sides, which belong to it.
std::vector<golden::Word> diagonal_slb_stream(const golden::HardwareConfig& config);

/// An object, then clears until its generation's number comes round again, with everything shown just before
/// and then.
std::vector<golden::Word> clearing_slb_stream(const golden::HardwareConfig& config);

/// One command.
std::vector<golden::Word> slb_command(golden::slb::SlbOp op, std::uint8_t flags, std::uint32_t arg,
                                      const std::vector<golden::Word>& items);

}  // namespace gnomon::rtl_test
