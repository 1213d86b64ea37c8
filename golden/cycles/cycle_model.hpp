// SPDX-License-Identifier: Apache-2.0
// Follows a golden engine through a stream and keeps the clock (docs/cycle-model.md). The engine tells every
// header and every item, in order, and what became of them where cycles depend on it.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/model.hpp>
#include <gnomon/golden/topology/codec.hpp>
#include <optional>
#include <span>
#include <vector>

#include "items.hpp"
#include "lists.hpp"
#include "look_up.hpp"
#include "outline.hpp"
#include "ports.hpp"
#include "run.hpp"
#include "slb_draw.hpp"
#include "slb_memory.hpp"
#include "slb_points.hpp"

namespace gnomon::golden::cycles {

/// Which of the items of a span came how far: number in the span, of the last one.
struct ItemWork {
  std::size_t items = 0;
  std::optional<std::size_t> last_updating = {};  ///< goes to the memory
  std::optional<std::size_t> last_writing = {};   ///< ... and changes its entry
  std::vector<Item> each = {};                    ///< all of them, where the model asks for it
};

class CycleModel {
 public:
  CycleModel(const HardwareConfig& config, const HardwareTiming& timing);

  /// So many more words are in memory; before they are told one by one.
  void submitted(std::size_t words);
  /// Whether it wants to know of each item of PROJECT_VOXELS and RESOLVE_VOXELS.
  bool asks_for_items() const { return ports_.has_value(); }
  /// ... and of COVER and QUERY.
  bool asks_for_pixels() const { return slb_memory_.has_value(); }
  /// A header, before its items. `fill`: what the last FILL swept, the command itself if it is one.
  void header(const Header& header, bool in_error, const slb::FillSweep& fill);
  /// Items that change nothing that cycles depend on: of NOP, SET_REGISTERS, RESOLVE_VOXELS, QUERY,
  /// LOOKUP_FRAME and commands in error.
  void items(std::size_t count);
  /// Items of PROJECT_VOXELS and COVER; of RESOLVE_VOXELS and QUERY where it asks for them.
  void items(const ItemWork& work);
  /// Items of PUT_QUADS and RESOLVE_TOPOLOGY, and the work that golden had with them.
  void items(std::size_t count, const topology::ListWork& work);
  /// Items of LOOP.
  void vertices(std::span<const Word> words);
  /// Everything so far, to the end of its drain.
  CycleTable table() const;

 private:
  int plane_lines_log2() const;
  int slb_lines_log2() const;
  int frame_lines_log2() const;
  static int touched_lines_log2(int lines_log2);
  static Cycle share(int lines_log2);  ///< lines that a clear scrubs, of a memory of 2^lines_log2
  void build_caches(int size_log2);
  CacheClock* cache();  ///< of the plane, if it has one
  void reset_scrub();
  void await_word(bool header);
  void give(Pass pass);
  void elapse(Cycle count);
  void spend(Pass pass, Cycle busy, Cycle memory_wait = 0);
  void end_run(bool more);
  Cycle take(std::size_t count);
  Cycle take_word();
  void clear_plane();
  void core_command();
  void slb_command(const slb::FillSweep& fill);
  void fill(const slb::FillSweep& sweep);
  void clear_unit(int lines_log2);
  void read_plane();
  void read(Cycle entries, Cycle words, Cycle ends);
  void close_if_complete();
  ListMemories list_memories();
  bool lists_idle();
  void clear_lists();
  void read_lists(const topology::EntryRange& range);
  void begin_lists();
  bool list_cycle(bool item, bool header, bool more);
  void end_lists(bool more);
  void begin_items(Pass pass);
  bool item_cycle(bool item, bool header);
  void take_items(std::span<const Item> items);
  void end_items();
  void covers(const ItemWork& work);
  void slb_header(std::optional<Pass> pass, const slb::FillSweep& fill);
  void begin_slb(Pass pass);
  void clear_slb();
  void fill_behind_cache(const slb::FillSweep& sweep);
  void read_entries_behind_cache();
  void pixels(std::span<const Item> items);
  void vertex_behind_cache(const DrawClock::Offer& offer);
  SlbMoves slb_moves(const Item* item, const DrawClock::Offer* vertex);
  bool slb_idle() const;
  bool slb_cycle(const Item* item, const DrawClock::Offer* vertex, bool header);
  void end_slb();
  void control_items(std::size_t count);
  void look_up(std::size_t count);

  HardwareConfig config_;
  HardwareTiming timing_;
  Cycle latency_;
  Cycle late_;  ///< stages more with EN_PERSPECTIVE

  Cycle now_ = 0;  ///< first cycle that nothing is known of
  CycleTable table_;
  Run run_;
  Header command_;
  bool flat_ = false;  ///< the object being drawn has one depth
  std::uint32_t items_left_ = 0;
  std::optional<Outline> outline_;            ///< with EN_SLB
  std::optional<LookUp> look_up_;             ///< with EN_FRAME_BUFFER
  std::optional<PutClock> put_;               ///< while a run of PUT_QUADS is open
  std::optional<CachedPutClock> cached_put_;  ///< ... with lists behind caches
  std::optional<WalkClock> walk_;             ///< ... of RESOLVE_TOPOLOGY
  std::uint32_t nodes_ = 0;                   ///< in use; counted behind caches
  std::optional<Ports> ports_;                ///< with HardwareTiming::system
  std::optional<ItemClock> items_;  ///< ... while a run of PROJECT_VOXELS, RESOLVE_VOXELS or QUERY is open
  Pass items_pass_ = Pass::Control;
  // With entries of the silhouette-line buffer behind caches.
  std::optional<SlbMemory> slb_memory_;
  std::optional<DrawClock> draw_;
  SampleClock samples_;
  PointClock points_;
  std::optional<Pass> slb_run_;  ///< while a run of LOOP, COVER or QUERY is open
  std::uint64_t submitted_ = 0;  ///< words
  bool takes_header_ = false;    ///< the next cycle takes a header
};

}  // namespace gnomon::golden::cycles
