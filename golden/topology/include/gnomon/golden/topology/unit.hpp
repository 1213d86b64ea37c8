// SPDX-License-Identifier: Apache-2.0
// Executes the commands of topology mode, with their errors: what the hardware answers
// (docs/vpu-topology.md).
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/topology/codec.hpp>
#include <gnomon/golden/topology/landing.hpp>
#include <gnomon/golden/topology/lists.hpp>
#include <span>
#include <vector>

namespace gnomon::golden::topology {

enum class TopologyError : std::uint8_t { None = 0, UnknownOp = 1, BadArgument = 4, ReservedFlag = 5 };

/// What one command came to.
struct TopologyOutcome {
  TopologyError error = TopologyError::None;
  std::vector<Word> results;  ///< empty if in error
};

/// The registers that the mode reads (docs/vpu.md), already cut to their widths.
struct ProjectionRegisters {
  std::array<std::int64_t, 12> matrix{};  ///< rows U, V, D: x, y, z, 1
  std::int64_t offset_factor = 0;
  perspective::Registers perspective;
};

class TopologyUnit {
 public:
  /// `config` must pass check(); throws std::invalid_argument otherwise.
  explicit TopologyUnit(const TopologyConfig& config) : lists_(config) {}

  void set_registers(const ProjectionRegisters& registers) { registers_ = registers; }

  /// A command with an op of this mode and all its items. In error it has no effect.
  TopologyOutcome execute(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                          std::span<const Word> items);

  /// The same in pieces: the error and results of the header, ...
  TopologyOutcome begin(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count);
  /// ... then those of its items, which may come in any number of pieces. Throws std::logic_error beyond the
  /// command's count.
  std::vector<Word> take(std::span<const Word> items);

  /// `clearance` in depth codes; in perspective in units of w, 24 bits.
  TopologyResult resolve(const Item& voxel, bool two_sided, std::uint32_t clearance, bool sorted);
  void put(const std::array<Item, 4>& corners);

  QuadLists& lists() { return lists_; }
  const QuadLists& lists() const { return lists_; }

 private:
  TopologyError check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) const;
  Projected project(const Item& item) const;
  Projected gradient(const Item& item) const;
  perspective::View view() const;
  void put_in_perspective(const std::array<Item, 4>& corners);
  TopologyResult answer(const Item& voxel, bool two_sided, std::uint32_t clearance, bool sorted);
  TopologyResult answer_in_perspective(const Item& voxel, bool two_sided, std::uint32_t clearance,
                                       bool sorted);
  TopologyResult walk(const Beam& beam, std::uint32_t clearance, bool sorted);
  void count(const TopologyResult& result);

  QuadLists lists_;
  ProjectionRegisters registers_;

  // The command at hand.
  TopologyOp op_ = TopologyOp::ClearLists;
  std::uint8_t flags_ = 0;
  std::uint32_t clearance_ = 0;
  std::size_t items_left_ = 0;
  std::array<Item, 4> corners_{};
  std::size_t corner_count_ = 0;
};

}  // namespace gnomon::golden::topology
