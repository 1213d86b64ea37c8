// SPDX-License-Identifier: Apache-2.0
// The silhouette-line buffer unit as a whole: objects in, answers out (docs/slb.md).
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <gnomon/golden/slb/chain_builder.hpp>
#include <gnomon/golden/slb/fragment_store.hpp>
#include <gnomon/golden/slb/query.hpp>
#include <gnomon/golden/slb/winding.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gnomon::golden::slb {

/// Event counters; the same on every engine (docs/command-stream.md, "Counters").
struct SlbCounters {
  std::uint64_t objects = 0;
  std::uint64_t loops = 0;        ///< closed, of any kind
  std::uint64_t loops_short = 0;  ///< fewer than three vertices: ignored
  std::uint64_t loops_tiny = 0;   ///< inside one pixel: cast nothing
  std::uint64_t tiny_area2 = 0;   ///< twice their area, square sub-pixels
  std::uint64_t vertices = 0;     ///< items taken
  std::uint64_t vertices_repeated = 0;
  std::uint64_t crossings = 0;  ///< pixel borders crossed, on the plane or off it
  std::uint64_t chains = 0;     ///< handed to the store
  std::uint64_t chains_off_plane = 0;
  std::uint64_t chains_dropped = 0;
  std::uint64_t chains_reduced = 0;
  std::uint64_t groups_evicted = 0;
  std::uint64_t winding_saturated = 0;
  std::uint64_t fill_pixels = 0;   ///< of the rows swept
  std::uint64_t fill_groups = 0;   ///< pixels with lines among them
  std::uint64_t fill_covered = 0;  ///< pixels that the object wholly covers
  std::uint64_t covers = 0;        ///< items of COVER
  std::uint64_t covers_used = 0;   ///< those that count as a full cover
  std::uint64_t queries = 0;
  std::uint64_t queries_shadow = 0;
  std::uint64_t queries_off_plane = 0;
  std::uint64_t queries_overflow = 0;  ///< answered by an entry where something did not fit
  bool operator==(const SlbCounters&) const = default;
};
/// With their names, in the order of docs/command-stream.md.
std::array<std::pair<const char*, std::uint64_t>, 23> named(const SlbCounters& counters);

/// Sticky flags of the unit, in the order of docs/slb.md.
struct SlbSticky {
  bool line_overflow = false;
  bool object_overflow = false;
  bool winding_saturated = false;
  bool operator==(const SlbSticky&) const = default;
};

/// A sample of a surface for COVER: one sheet in one pixel of the plane, the farthest that it reaches there.
struct CoverSample {
  std::int64_t column = 0, row = 0;
  std::uint32_t depth = 0;
  std::uint32_t range = 0;  ///< 0..31: nowhere in the pixel is it nearer than depth - (2^range - 1)
};

/// What FILL met in a line of pixels; a row is cut into lines of kLinePixels, or is one if it has fewer.
struct FillLine {
  std::uint16_t pixels = 0;  ///< those with lines, the first one's bit lowest
  bool covered = false;      ///< the object wholly covers the line's last pixel, by its winding number

  int groups() const { return std::popcount(pixels); }
  bool plain() const { return pixels == 0; }
};
inline constexpr int kLinePixels = 16;

/// How much work FILL of one object was: no answer depends on it.
struct FillSweep {
  int first_row = 0, last_row = -1;  ///< rows swept; none if the first is beyond the last
  std::vector<FillLine> lines;       ///< of these rows
};

/// Calls out of order (a loop without an object, a query inside one) throw std::logic_error.
class SlbModel {
 public:
  /// `config` must pass check(); throws std::invalid_argument otherwise.
  explicit SlbModel(const SlbConfig& config);
  SlbModel(const SlbModel&) = delete;
  SlbModel& operator=(const SlbModel&) = delete;

  const SlbConfig& config() const { return config_; }
  /// As after power-up.
  void reset();
  /// Empties the plane. Not inside an object.
  void clear();

  /// A flat caster has `depth` everywhere; otherwise each vertex brings its own.
  void begin_object(std::uint8_t object, bool flat, std::uint32_t depth);
  /// A loop begins or goes on; `vertex` does this too.
  void enter_loop();
  void vertex(const Vertex& vertex);
  void close_loop();
  /// A whole loop.
  void loop(std::span<const Vertex> vertices);
  /// After all loops of the object, once.
  void fill();
  /// After fill: a sample of the object's surface. `margin` in depth codes.
  void cover(const CoverSample& sample, std::uint32_t margin);
  void end_object();

  QueryAnswer query(const QueryPoint& point, std::uint32_t bias);

  enum class State : std::uint8_t { Idle, Object, Loop, Filled };
  State state() const { return state_; }
  /// The object open now has had a loop.
  bool has_loops() const { return has_loops_; }

  Entry entry(int column, int row) const { return store_.read(column, row); }
  const SlbCounters& counters() const { return counters_; }
  const SlbSticky& sticky() const { return sticky_; }
  void clear_sticky() { sticky_ = SlbSticky{}; }
  /// Every FILL from now on tells `sweep` what it met. Null: no longer. Not owned.
  void watch_fill(FillSweep* sweep) { sweep_ = sweep; }

 private:
  void note_row(std::span<const Winding::Pixel> row);
  bool on_plane(std::int64_t column, std::int64_t row) const;
  void require(bool condition, const char* what) const;
  void put(Chain chain);
  void cross_row(std::int64_t column, std::int64_t row, bool upwards);

  SlbConfig config_;
  FragmentStore store_;
  Winding winding_;
  ChainBuilder builder_;
  State state_ = State::Idle;
  bool has_loops_ = false, flat_ = false;
  std::uint8_t object_ = 0;
  std::uint32_t depth_ = 0;
  SlbCounters counters_;
  SlbSticky sticky_;
  FillSweep* sweep_ = nullptr;
};

}  // namespace gnomon::golden::slb
