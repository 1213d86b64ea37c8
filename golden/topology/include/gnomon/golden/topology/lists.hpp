// SPDX-License-Identifier: Apache-2.0
// The lists of quads over the plane: linking, and walking one for a beam (docs/vpu-topology.md).
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/topology/config.hpp>
#include <gnomon/golden/topology/landing.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::golden::topology {

/// Event counters; the same on every engine.
struct TopologyCounters {
  std::uint64_t quads_put = 0;
  std::uint64_t quads_off_plane = 0;  ///< the box misses the plane
  std::uint64_t quads_too_large = 0;  ///< the box meets the plane and spans more than 2^SPAN_LOG2 entries
  std::uint64_t quads_saturated = 0;  ///< the box meets the plane, and a corner's depth was saturated
  std::uint64_t nodes_linked = 0;
  std::uint64_t nodes_dropped = 0;  ///< entries that lost a quad
  std::uint64_t resolved = 0;
  std::uint64_t facing_away = 0;
  std::uint64_t off_plane = 0;
  std::uint64_t uncertain = 0;
  std::uint64_t hit = 0;
  std::uint64_t fallback = 0;
  std::uint64_t shadow = 0;
  std::uint64_t nodes_visited = 0;
  std::uint64_t quads_tested = 0;
  // Perspective.
  std::uint64_t quads_behind = 0;      ///< all corners behind the light
  std::uint64_t quads_straddling = 0;  ///< some, not all
  std::uint64_t behind = 0;
  std::uint64_t outside_cone = 0;
  bool operator==(const TopologyCounters&) const = default;
};

/// Their names in docs/vpu-topology.md; those of the perspective projection only on request.
std::vector<std::pair<std::string, std::uint64_t>> named(const TopologyCounters& counters, bool perspective);

/// Sticky flags that this mode raises.
struct TopologySticky {
  bool list_overflow = false;
  bool quad_off_plane = false;
  bool depth_saturated = false;
  bool behind_light = false;
  bool operator==(const TopologySticky&) const = default;
};

/// What is known of an entry without walking its list.
struct ListHead {
  bool present = false;    ///< touched since the last clear
  bool linked = false;     ///< the list has a node
  bool dropped = false;    ///< a quad did not fit
  std::uint32_t near = 0;  ///< nearest of the quads' far depths, dropped ones too; 0 unless present
  bool operator==(const ListHead&) const = default;
};

inline constexpr std::uint32_t kNoQuad = 0xFFFFFF;

/// What the walk of a list came to.
struct Walk {
  bool uncertain = false, hit = false, fallback = false;
  std::uint32_t quad = kNoQuad;
  std::uint64_t visited = 0, tested = 0;
};

/// How much work quads and voxels were, and where: no answer depends on it.
struct ListWork {
  /// The entries that a quad put was offered to; none if it was not linked at all.
  struct Quad {
    std::uint32_t number = 0;
    std::uint32_t u = 0, v = 0, columns = 0, rows = 0;
    bool storable = false;  ///< has a record, and nodes while there are some

    std::uint64_t entries() const { return std::uint64_t{columns} * rows; }
  };
  struct Voxel {
    std::uint32_t visited = 0;   ///< nodes
    std::uint32_t u = 0, v = 0;  ///< of its entry; off the plane with their low bits alone
  };
  struct Node {
    std::uint32_t index = 0, quad = 0;
    bool tested = false;  ///< its quad was
  };
  std::vector<Quad> quads;
  std::vector<Voxel> voxels;
  std::vector<Node> nodes;  ///< visited for these voxels
};

class QuadLists {
 public:
  /// `config` must pass check(); throws std::invalid_argument otherwise.
  explicit QuadLists(const TopologyConfig& config);

  /// All lists empty, numbers begin at 0. Counters and flags stay.
  void clear();
  /// As after power-up.
  void reset();
  /// Links the next quad.
  void put(const std::array<Corner, 4>& corners);
  /// The next quad has corners behind the light: it is dropped.
  void put_behind(bool all_corners);
  /// `beam` must be on the plane. With `sorted` the walk stops at the first quad that is not wholly nearer.
  Walk walk(const Beam& beam, std::uint32_t clearance, bool sorted);

  /// `index`: v * 2^PLANE_LOG2 + u.
  ListHead head(std::size_t index) const;
  /// Quad numbers of a list, the first to be visited first.
  std::vector<std::uint32_t> list(std::size_t index) const;

  const TopologyConfig& config() const { return config_; }
  TopologyCounters& counters() { return counters_; }
  const TopologyCounters& counters() const { return counters_; }
  const TopologySticky& sticky() const { return sticky_; }
  void clear_sticky() { sticky_ = {}; }
  /// Everything from now on is added to `work`. Null: no longer. Not owned.
  void watch(ListWork* work) { work_ = work; }
  /// A voxel is resolved; what its walk visits counts for it.
  void note_voxel() {
    if (work_) work_->voxels.emplace_back();
  }
  bool watched() const { return work_ != nullptr; }
  /// The voxel's beam, which may miss the plane or not be looked for.
  void note_beam(const Beam& beam);

 private:
  static constexpr std::uint32_t kNoNode = 0xFFFFFFFF;
  struct Head {
    std::uint32_t generation = 0;  // of the lists; any other is empty
    std::uint32_t near = 0;
    std::uint32_t node = kNoNode;
    bool dropped = false;
  };
  struct Node {
    std::uint32_t next, far, quad;
  };
  struct Place {
    std::int64_t u, v;
  };
  using Record = std::array<Place, 4>;  // corners, sub-entries
  struct Range {
    std::int64_t low, high;
    bool operator==(const Range&) const = default;
  };
  struct Box {
    Range u, v;
    bool operator==(const Box&) const = default;
  };

  void link(std::size_t index, std::uint32_t quad, std::uint32_t far, bool storable);
  std::uint32_t next_number();
  void note_quad(const ListWork::Quad& quad) {
    if (work_) work_->quads.push_back(quad);
  }
  void note_node(std::uint32_t index, bool tested) {
    if (!work_) return;
    ++work_->voxels.back().visited;
    work_->nodes.push_back({index, nodes_[index].quad, tested});
  }
  static Box box_of(const std::array<Corner, 4>& corners, int sub_bits);
  bool meets_plane(const std::array<Corner, 4>& corners, const Box& box, const Box& clipped);

  TopologyConfig config_;
  std::uint32_t generation_ = 1;
  std::uint32_t numbered_ = 0;
  std::vector<Head> heads_;
  std::vector<Node> nodes_;
  std::vector<Record> records_;
  TopologyCounters counters_;
  TopologySticky sticky_;
  ListWork* work_ = nullptr;
};

}  // namespace gnomon::golden::topology
