// SPDX-License-Identifier: Apache-2.0
// Cuts a loop into chains: what it does between entering and leaving a pixel (docs/slb.md, "Chains").
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/slb/edge_walker.hpp>
#include <optional>

namespace gnomon::golden::slb {

/// A finished chain, ready for the fragment store.
struct Chain {
  std::int64_t column = 0, row = 0;
  FragmentOp op = FragmentOp::One;  ///< One, And or Or
  Line a, b;                        ///< b only with And and Or
  bool holds_corner = false;        ///< the chain's inner side contains the pixel's lower left corner
  std::uint32_t depth = 0;
  int vertices = 0;  ///< corners of the loop in it, 2 for two or more
};

/// What one loop came to.
struct LoopSummary {
  std::uint64_t vertices = 0;  ///< without repeats
  std::uint64_t repeated = 0;  ///< vertices equal to their predecessor
  std::uint64_t crossings = 0;
  bool too_short = false;        ///< fewer than three vertices: not walked
  bool tiny = false;             ///< never left its first pixel: casts nothing
  std::uint64_t tiny_area2 = 0;  ///< twice its area in square sub-pixels
};

class ChainBuilder {
 public:
  using ChainSink = std::function<void(const Chain&)>;
  /// Called for every crossing of a border y = row: (column, row, upwards).
  using WindingSink = std::function<void(std::int64_t, std::int64_t, bool)>;

  ChainBuilder(const SlbConfig& config, ChainSink on_chain, WindingSink on_winding);

  void vertex(const Vertex& vertex);
  /// Closes the loop and forgets it.
  LoopSummary close();
  /// Of the loop so far.
  std::uint64_t crossings() const { return crossings_; }
  std::uint64_t repeated() const { return repeated_; }
  /// Forgets a loop that was not closed.
  void forget();

 private:
  struct Partial {
    std::int64_t column = 0, row = 0;
    bool has_entry = false;
    Side entry = Side::Bottom;
    Line a;
    std::int64_t entry_dx = 0, entry_dy = 0;
    int vertices = 0;
    Vertex first, last;
    std::uint32_t depth = 0;
  };
  struct FirstExit {
    Side exit = Side::Bottom;
    Line b;
    std::int64_t dx = 0, dy = 0;
    Vertex last;
    int vertices = 0;
    std::uint32_t depth = 0;
  };

  void edge(const Vertex& from, const Vertex& to);
  void add_vertex(Partial& chain, const Vertex& vertex) const;
  void leave(const FirstExit& exit);
  Chain finish(const Partial& chain, const FirstExit& exit) const;

  SlbConfig config_;
  ChainSink on_chain_;
  WindingSink on_winding_;

  std::uint64_t count_ = 0, repeated_ = 0, crossings_ = 0;
  Vertex origin_, previous_, pending_;
  Partial chain_;
  std::optional<FirstExit> first_exit_;
  std::int64_t area2_ = 0;
};

}  // namespace gnomon::golden::slb
