// SPDX-License-Identifier: Apache-2.0
// The page's geometry once more, in unbounded rationals and without any of the model's code.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <gnomon/golden/slb/edge_walker.hpp>
#include <vector>

namespace gnomon::golden::slb::testing {

/// Without expression templates: `auto` and std::max then mean what they say.
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// The sides by which the shifted edge leaves one pixel after the other.
std::vector<Side> reference_walk(const Vertex& from, const Vertex& to, const SlbConfig& config);

/// Where the edge's line meets the major border of index `border`, pixels.
Rational reference_crossing(const Vertex& from, const Vertex& to, std::int64_t border,
                            const SlbConfig& config);

/// A walker's position as a number of pixels.
Rational value_of(const Position& position, const EdgeSetup& edge, const SlbConfig& config);

/// Minor coordinate of a stored line at major coordinate `at` (0..1), as the page restores it.
Rational restored(const Line& line, const Rational& at, const SlbConfig& config);

/// The bound of the page on a restored line at M = 0 and M = 1.
Rational restored_bound(const SlbConfig& config);

/// Walks an edge and compares every side and both crossings of every pixel; returns the number of
/// comparisons, or -1 after the first difference. `fault` is added to every k: a checker that cannot fail is
/// none.
std::int64_t check_walk(const Vertex& from, const Vertex& to, const SlbConfig& config,
                        std::int64_t fault = 0);

}  // namespace gnomon::golden::slb::testing
