// SPDX-License-Identifier: Apache-2.0
// Topology mode as docs/vpu-topology.md has it, in exact rationals and without lists: every voxel looks at
// every quad. Shares no arithmetic with the golden model.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <gnomon/golden/topology/unit.hpp>
#include <optional>
#include <vector>

#include "tests/golden/perspective_oracle.hpp"

namespace gnomon::test {

// Without expression templates: every intermediate result is a value of its own.
using IntegerBackend = boost::multiprecision::cpp_int_backend<>;
using Integer = boost::multiprecision::number<IntegerBackend, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::rational_adaptor<IntegerBackend>,
                                               boost::multiprecision::et_off>;
using Point = std::array<Rational, 3>;  ///< u, v, depth

Integer floor(const Rational& x);
/// Largest multiple of 2^-bits not above x.
Rational floor_to(const Rational& x, int bits);

/// The published form: the beam from `start` towards smaller depth meets the triangle's plane, and five dot
/// products say whether inside. Triangles that contain the beam's direction are not met.
bool paper_hit(const Point& start, const Point& v0, const Point& v1, const Point& v2);
/// The light-space form: areas, then the sign of the weighted depths; no division.
bool light_space_hit(const Point& start, const Point& v0, const Point& v1, const Point& v2);

/// The whole mode.
class TopologyReference {
 public:
  TopologyReference(const golden::topology::TopologyConfig& config,
                    const golden::topology::ProjectionRegisters& registers)
      : config_(config), registers_(registers) {}
  /// In perspective: `light` knows the registers.
  TopologyReference(const golden::topology::TopologyConfig& config, const exact::PerspectiveUnit& light)
      : config_(config), light_(light) {}

  void put(const std::array<golden::topology::Item, 4>& corners);
  golden::topology::TopologyResult resolve(const golden::topology::Item& voxel, bool two_sided,
                                           std::uint32_t clearance, bool sorted) const;
  golden::topology::ListHead head(std::int64_t u, std::int64_t v) const;
  /// Numbers of the quads linked to an entry, the last one first.
  std::vector<std::uint32_t> list(std::int64_t u, std::int64_t v) const;

 private:
  using TopologyConfig = golden::topology::TopologyConfig;
  struct Quad {
    std::uint32_t number;
    std::array<Point, 4> corners;  // in sub-entries and depth codes
    Integer far;
    Integer u0, u1, v0, v1;  // box, clipped
    std::uint64_t linked;    // how many of its entries, from the first on, got a node
    bool meets(const Integer& u, const Integer& v) const;
    bool linked_to(const Integer& u, const Integer& v) const;
  };

  Point orthographic_place(const golden::topology::Item& item) const;
  /// Nothing behind the light.
  std::optional<Point> place(const golden::topology::Item& item) const;
  /// The beam of a voxel; nothing if `result` says why there is none.
  std::optional<Point> beam(const golden::topology::Item& voxel, bool two_sided, std::uint32_t& clearance,
                            golden::topology::TopologyResult& result) const;
  Rational row(std::size_t first, const std::array<Rational, 3>& at, int fraction_bits) const;
  Rational saturated(const Rational& depth) const;

  TopologyConfig config_;
  golden::topology::ProjectionRegisters registers_;
  std::optional<exact::PerspectiveUnit> light_;
  std::uint32_t numbered_ = 0;
  std::uint64_t nodes_ = 0;
  std::vector<Quad> quads_;
};

}  // namespace gnomon::test
