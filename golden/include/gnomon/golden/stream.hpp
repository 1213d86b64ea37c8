// SPDX-License-Identifier: Apache-2.0
// Writing command streams, and walking through them (docs/command-stream.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/slb/sequence.hpp>
#include <gnomon/golden/topology/codec.hpp>
#include <optional>
#include <span>
#include <vector>

namespace gnomon::golden {

/// What a resolve command does with its states where there is a frame buffer.
struct Keeping {
  std::uint32_t layer = 0;
  bool quiet = true;  ///< no result words
};

/// Appends sound commands to a stream that starts at reset. Lists of more than kMaxItems items become several
/// commands.
class StreamWriter {
 public:
  /// `config` must be legal.
  explicit StreamWriter(const HardwareConfig& config) : config_(config) {}

  /// Throws std::out_of_range, naming the register, if `value` does not fit the register.
  void set_register(Register reg, std::int64_t value);
  /// One command for `values` of `first` and the registers after it. Throws std::out_of_range as above, or if
  /// there are fewer registers; nothing is written then.
  void set_registers(Register first, std::span<const std::int64_t> values);
  void clear_plane();
  /// `clear_sticky`: clear the sticky flags after reporting them.
  void fence(std::uint32_t tag, bool clear_sticky);
  /// Any number of entries, in commands of at most 256. Throws std::out_of_range beyond the plane.
  void read_plane(std::uint32_t first, std::uint32_t count);
  void project(std::span<const VoxelItem> items);
  void resolve(std::span<const VoxelItem> items, bool two_sided);

  // Topology mode. All of these throw std::logic_error if the hardware has no such mode, and
  // std::out_of_range if a field does not fit its bits; nothing is written then.
  void clear_lists();
  /// Corners c0, c1, c2, c3; c3 = c2 for a triangle.
  void put_quads(std::span<const std::array<VoxelItem, 4>> quads);
  /// `clearance` in depth codes, in perspective in units of w (docs/vpu-topology.md); `sorted`: quads were
  /// sent by descending `far`.
  void resolve_topology(std::span<const VoxelItem> items, bool two_sided, std::uint32_t clearance,
                        bool sorted);
  /// Any number of entries, in commands of at most 256.
  void read_lists(std::uint32_t first, std::uint32_t count);

  // The frame buffer. All of these throw std::logic_error if the hardware has none, and std::out_of_range if
  // it has no such layer; nothing is written then.
  void clear_frame();
  /// What the resolve commands written from now on do with their states; nothing: they give result words.
  void keep(std::optional<Keeping> keep);
  /// The states of these voxels; with `bricks`, of the whole bricks that they lie in.
  void look_up(std::span<const VoxelItem> items, std::uint32_t layer, bool bricks);

  // The silhouette-line buffer. All of these throw std::logic_error if the hardware has no such unit or the
  // command may not follow on those before, and std::out_of_range if a field does not fit its bits; nothing
  // is written then.
  void slb_clear();
  /// A flat caster has one depth code everywhere; without, every vertex brings its own.
  void begin_object(std::uint8_t object, std::optional<std::uint32_t> flat_depth = std::nullopt);
  /// A whole loop, interior on its left.
  void loop(std::span<const slb::Vertex> vertices);
  void fill();
  /// `margin` in depth codes.
  void cover(std::span<const slb::CoverSample> samples, std::uint32_t margin);
  void end_object();
  /// `bias` in depth codes.
  void query(std::span<const slb::QueryPoint> points, std::uint32_t bias);
  /// Any number of entries, in commands of at most 256.
  void read_entries(std::uint32_t first, std::uint32_t count);

  const std::vector<Word>& words() const { return words_; }
  /// Hands the stream over and starts an empty one.
  std::vector<Word> take();

 private:
  void header(Op op, std::uint8_t flags, std::size_t count, std::uint32_t arg);
  void voxels(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::span<const VoxelItem> items);
  std::uint32_t layer_arg(std::uint32_t layer) const;
  std::uint32_t clearance_arg(std::uint32_t clearance) const;
  void topology_header(topology::TopologyOp op, std::uint8_t flags, std::size_t count, std::uint32_t arg);
  void slb_header(slb::SlbOp op, std::uint8_t flags, std::size_t count, std::uint32_t arg);
  template <typename Item>
  void slb_items(slb::SlbOp op, std::uint32_t arg, std::span<const Item> items);
  std::uint32_t depth_code(const char* name, std::uint32_t depth) const;

  HardwareConfig config_;
  std::vector<Word> words_;
  std::optional<Keeping> keep_;
  bool in_perspective_ = false;  ///< as PROJECTION was last set
  slb::SlbSequence slb_;         ///< as the commands written leave it
};

/// One command inside a stream.
struct Command {
  std::uint32_t index = 0;  ///< command index, from 0, modulo 2^32
  std::size_t offset = 0;   ///< of the header, in words from the start of the stream
  Header header;
  std::span<const Word> items;  ///< fewer than header.count if the stream ends in the middle
};

/// Walks a stream: `CommandReader reader(words); while (auto command = reader.next()) ...`. `words` must
/// outlive it.
class CommandReader {
 public:
  explicit CommandReader(std::span<const Word> words) : words_(words) {}
  /// Nothing at the end of the stream.
  std::optional<Command> next();

 private:
  std::span<const Word> words_;
  std::size_t offset_ = 0;
  std::uint32_t index_ = 0;
};

/// Which command a result word answers.
struct ResultOrigin {
  Command command;
  /// Number of the result among the command's: of the item, of the entry read.
  std::uint32_t result = 0;
  /// Of an entry of READ_ENTRIES: the word is its raw word with this number, not its SLB_ENTRY word.
  std::optional<std::uint32_t> raw_word;
};

/// The origin of result word `result` of a stream that starts at reset; nothing if the stream has fewer
/// results.
std::optional<ResultOrigin> find_result(std::span<const Word> words, std::uint64_t result,
                                        const HardwareConfig& config);

/// One result of a result stream.
struct ResultRecord {
  std::size_t offset = 0;  ///< of the word, in words from the start
  Word word = 0;
  std::span<const Word> raw;  ///< an SLB_ENTRY's raw words; fewer than it announces if the stream ends there
};

/// Walks results: `ResultReader reader(words); while (auto result = reader.next()) ...`. Raw words may look
/// like any result; this keeps them apart. `words` must outlive it.
class ResultReader {
 public:
  explicit ResultReader(std::span<const Word> words) : words_(words) {}
  /// Nothing at the end of the stream.
  std::optional<ResultRecord> next();

 private:
  std::span<const Word> words_;
  std::size_t offset_ = 0;
};

}  // namespace gnomon::golden
