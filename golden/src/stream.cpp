// SPDX-License-Identifier: Apache-2.0
// Command streams, written and walked through.
#include <algorithm>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/narrow.hpp>
#include <gnomon/golden/perspective/view.hpp>
#include <gnomon/golden/stream.hpp>
#include <stdexcept>
#include <string>
#include <utility>

namespace gnomon::golden {
namespace {

Word register_word(Register reg, std::int64_t value, const HardwareConfig& config) {
  const RegisterFormat format = register_format(reg, config);
  if (format.is_signed ? fits_signed(value, format.width) : fits_unsigned(value, format.width)) {
    return low_bits(static_cast<Word>(value), format.width);
  }
  throw std::out_of_range(std::string(format.name) + "=" + std::to_string(value) + " does not fit " +
                          std::to_string(format.width) + (format.is_signed ? " signed" : " unsigned") +
                          " bits");
}

int keep_flags(const std::optional<Keeping>& keep) {
  return keep ? frame::kKeep | (keep->quiet ? frame::kQuiet : 0) : 0;
}

}  // namespace

void StreamWriter::set_register(Register reg, std::int64_t value) {
  set_registers(reg, {&value, 1});
}

void StreamWriter::set_registers(Register first, std::span<const std::int64_t> values) {
  const auto start = static_cast<std::size_t>(first);
  const auto registers = static_cast<std::size_t>(register_count(config_));
  if (start + values.size() > registers) {
    throw std::out_of_range("register " + std::to_string(start) + " + " + std::to_string(values.size()) +
                            " values is beyond the last register " + std::to_string(registers - 1));
  }
  std::vector<Word> encoded;
  for (std::size_t i = 0; i < values.size(); ++i) {
    encoded.push_back(register_word(static_cast<Register>(start + i), values[i], config_));
  }
  header(Op::SetRegisters, 0, values.size(), static_cast<std::uint32_t>(start));
  const auto projection = static_cast<std::size_t>(Register::Projection);
  if (start <= projection && projection < start + values.size())
    in_perspective_ = (values[projection - start] & kProjectionPerspective) != 0;
  words_.insert(words_.end(), encoded.begin(), encoded.end());
}

void StreamWriter::clear_plane() {
  header(Op::ClearPlane, 0, 0, 0);
}

void StreamWriter::fence(std::uint32_t tag, bool clear_sticky) {
  header(Op::Fence, clear_sticky ? kFenceClearSticky : 0, 0, tag);
}

void StreamWriter::read_plane(std::uint32_t first, std::uint32_t count) {
  const std::uint64_t entries = std::uint64_t{1} << (2 * config_.plane_log2);
  if (std::uint64_t{first} + count > entries) {
    throw std::out_of_range("plane entries " + std::to_string(first) + " + " + std::to_string(count) +
                            " are beyond the plane's " + std::to_string(entries));
  }
  while (count > 0) {
    const std::uint32_t n = std::min(count, std::uint32_t{256});
    header(Op::ReadPlane, 0, 0, encode(PlaneRange{.first = first, .count = n}));
    first += n;
    count -= n;
  }
}

void StreamWriter::project(std::span<const VoxelItem> items) {
  voxels(static_cast<std::uint8_t>(Op::ProjectVoxels), 0, 0, items);
}

void StreamWriter::resolve(std::span<const VoxelItem> items, bool two_sided) {
  const int flags = (two_sided ? kResolveTwoSided : 0) | keep_flags(keep_);
  voxels(static_cast<std::uint8_t>(Op::ResolveVoxels), static_cast<std::uint8_t>(flags),
         keep_ ? frame::layer_arg(keep_->layer) : 0, items);
}

std::vector<Word> StreamWriter::take() {
  return std::exchange(words_, {});
}

void StreamWriter::header(Op op, std::uint8_t flags, std::size_t count, std::uint32_t arg) {
  words_.push_back(encode(Header{.op = static_cast<std::uint8_t>(op),
                                 .flags = flags,
                                 .count = static_cast<std::uint16_t>(count),
                                 .arg = arg}));
}

void StreamWriter::clear_lists() {
  topology_header(topology::TopologyOp::ClearLists, 0, 0, 0);
}

void StreamWriter::put_quads(std::span<const std::array<VoxelItem, 4>> quads) {
  constexpr std::size_t kMostQuads = kMaxItems / topology::kWordsPerQuad;
  while (!quads.empty()) {
    const auto part = quads.first(std::min(quads.size(), kMostQuads));
    topology_header(topology::TopologyOp::PutQuads, 0, part.size() * topology::kWordsPerQuad, 0);
    for (const auto& quad : part)
      for (const VoxelItem& corner : quad) words_.push_back(encode(corner, config_));
    quads = quads.subspan(part.size());
  }
}

void StreamWriter::resolve_topology(std::span<const VoxelItem> items, bool two_sided, std::uint32_t clearance,
                                    bool sorted) {
  constexpr auto kOp = topology::TopologyOp::ResolveTopology;
  const std::uint32_t arg = clearance_arg(clearance) | (keep_ ? frame::layer_arg(keep_->layer) : 0);
  const int flags =
      (two_sided ? topology::kTwoSided : 0) | (sorted ? topology::kSorted : 0) | keep_flags(keep_);
  // For its exception.
  if (!config_.en_vpu_topology) topology_header(kOp, static_cast<std::uint8_t>(flags), items.size(), arg);
  voxels(static_cast<std::uint8_t>(kOp), static_cast<std::uint8_t>(flags), arg, items);
}

void StreamWriter::read_lists(std::uint32_t first, std::uint32_t count) {
  const std::uint64_t entries = std::uint64_t{1} << (2 * config_.plane_log2);
  if (std::uint64_t{first} + count > entries) {
    throw std::out_of_range("lists " + std::to_string(first) + " + " + std::to_string(count) +
                            " are beyond the plane's " + std::to_string(entries));
  }
  while (count > 0) {
    const std::uint32_t n = std::min(count, std::uint32_t{256});
    topology_header(topology::TopologyOp::ReadLists, 0, 0,
                    topology::encode(topology::EntryRange{.first = first, .count = n}));
    first += n;
    count -= n;
  }
}

void StreamWriter::topology_header(topology::TopologyOp op, std::uint8_t flags, std::size_t count,
                                   std::uint32_t arg) {
  const Header header{.op = static_cast<std::uint8_t>(op),
                      .flags = flags,
                      .count = static_cast<std::uint16_t>(count),
                      .arg = arg};
  if (!config_.en_vpu_topology)
    throw std::logic_error(describe_header(encode(header)) + ": EN_VPU_TOPOLOGY is 0");
  words_.push_back(encode(header));
}

void StreamWriter::slb_clear() {
  slb_header(slb::SlbOp::Clear, 0, 0, 0);
}

void StreamWriter::begin_object(std::uint8_t object, std::optional<std::uint32_t> flat_depth) {
  const std::uint32_t arg = std::uint32_t{object} << 24 | depth_code("depth", flat_depth.value_or(0));
  slb_header(slb::SlbOp::BeginObject, flat_depth ? slb::kBeginFlat : 0, 0, arg);
}

void StreamWriter::loop(std::span<const slb::Vertex> vertices) {
  if (vertices.empty()) return slb_header(slb::SlbOp::Loop, 0, 0, 0);
  slb_items(slb::SlbOp::Loop, 0, vertices);
}

void StreamWriter::fill() {
  slb_header(slb::SlbOp::Fill, 0, 0, 0);
}

void StreamWriter::cover(std::span<const slb::CoverSample> samples, std::uint32_t margin) {
  slb_items(slb::SlbOp::Cover, depth_code("margin", margin), samples);
}

void StreamWriter::end_object() {
  slb_header(slb::SlbOp::EndObject, 0, 0, 0);
}

void StreamWriter::query(std::span<const slb::QueryPoint> points, std::uint32_t bias) {
  slb_items(slb::SlbOp::Query, depth_code("bias", bias), points);
}

void StreamWriter::read_entries(std::uint32_t first, std::uint32_t count) {
  const std::uint64_t entries = std::uint64_t{1} << (2 * config_.slb_plane_log2);
  if (std::uint64_t{first} + count > entries) {
    throw std::out_of_range("SLB entries " + std::to_string(first) + " + " + std::to_string(count) +
                            " are beyond the plane's " + std::to_string(entries));
  }
  while (count > 0) {
    const std::uint32_t n = std::min(count, std::uint32_t{256});
    slb_header(slb::SlbOp::ReadEntries, 0, 0, slb::encode(slb::EntryRange{.first = first, .count = n}));
    first += n;
    count -= n;
  }
}

void StreamWriter::slb_header(slb::SlbOp op, std::uint8_t flags, std::size_t count, std::uint32_t arg) {
  const Header header{.op = static_cast<std::uint8_t>(op),
                      .flags = flags,
                      .count = static_cast<std::uint16_t>(count),
                      .arg = arg};
  if (!config_.en_slb) throw std::logic_error(describe_header(encode(header)) + ": EN_SLB is 0");
  if (!slb_.allows(op)) throw std::logic_error(describe_header(encode(header)) + ": out of sequence");
  slb_.advance(op, flags);
  words_.push_back(encode(header));
}

/// Items are encoded first, so that one that does not fit leaves nothing half written.
template <typename Item>
void StreamWriter::slb_items(slb::SlbOp op, std::uint32_t arg, std::span<const Item> items) {
  std::vector<Word> encoded;
  encoded.reserve(items.size());
  for (const Item& item : items) encoded.push_back(slb::encode(item, config_.slb_config()));
  std::span<const Word> rest = encoded;
  while (!rest.empty()) {
    const auto part = rest.first(std::min(rest.size(), std::size_t{kMaxItems}));
    rest = rest.subspan(part.size());
    const bool goes_on = op == slb::SlbOp::Loop && !rest.empty();
    slb_header(op, goes_on ? slb::kLoopMore : 0, part.size(), arg);
    words_.insert(words_.end(), part.begin(), part.end());
  }
}

std::uint32_t StreamWriter::depth_code(const char* name, std::uint32_t depth) const {
  if (depth <= config_.slb_config().no_depth()) return depth;
  throw std::out_of_range(std::string(name) + "=" + std::to_string(depth) + " does not fit " +
                          std::to_string(config_.depth_bits) + " bits");
}

std::uint32_t StreamWriter::clearance_arg(std::uint32_t clearance) const {
  if (!in_perspective_) return depth_code("clearance", clearance);
  if (clearance >> perspective::kClearanceBits == 0) return clearance;
  throw std::out_of_range("clearance=" + std::to_string(clearance) + " does not fit " +
                          std::to_string(perspective::kClearanceBits) + " bits");
}

void StreamWriter::voxels(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                          std::span<const VoxelItem> items) {
  while (!items.empty()) {
    const auto part = items.first(std::min(items.size(), std::size_t{kMaxItems}));
    words_.push_back(encode(
        Header{.op = op, .flags = flags, .count = static_cast<std::uint16_t>(part.size()), .arg = arg}));
    for (const VoxelItem& item : part) words_.push_back(encode(item, config_));
    items = items.subspan(part.size());
  }
}

void StreamWriter::clear_frame() {
  layer_arg(0);
  words_.push_back(encode(Header{.op = static_cast<std::uint8_t>(frame::FrameOp::ClearFrame)}));
}

void StreamWriter::keep(std::optional<Keeping> keep) {
  if (keep) layer_arg(keep->layer);
  keep_ = keep;
}

void StreamWriter::look_up(std::span<const VoxelItem> items, std::uint32_t layer, bool bricks) {
  voxels(static_cast<std::uint8_t>(frame::FrameOp::LookupFrame), bricks ? frame::kBrick : 0, layer_arg(layer),
         items);
}

std::uint32_t StreamWriter::layer_arg(std::uint32_t layer) const {
  if (!config_.en_frame_buffer) throw std::logic_error("states cannot be kept: EN_FRAME_BUFFER is 0");
  if (layer < config_.frame_config().layers()) return frame::layer_arg(layer);
  throw std::out_of_range("layer=" + std::to_string(layer) + " is beyond the frame buffer's " +
                          std::to_string(config_.frame_config().layers()));
}

std::optional<Command> CommandReader::next() {
  if (offset_ >= words_.size()) return std::nullopt;
  const Header header = decode_header(words_[offset_]);
  const auto rest = words_.subspan(offset_ + 1);
  const Command command{.index = index_,
                        .offset = offset_,
                        .header = header,
                        .items = rest.first(std::min(rest.size(), std::size_t{header.count}))};
  ++index_;
  offset_ += 1 + command.items.size();
  return command;
}

std::optional<ResultOrigin> find_result(std::span<const Word> words, std::uint64_t result,
                                        const HardwareConfig& config) {
  CommandReader reader(words);
  CommandSequence sequence(config);
  while (const auto command = reader.next()) {
    const auto error = sequence.next(command->header);
    const std::uint32_t count = result_count(command->header, error, config);
    if (result >= count) {
      result -= count;
      continue;
    }
    const auto number = static_cast<std::uint32_t>(result);
    const bool entries = command->header.op == static_cast<std::uint8_t>(slb::SlbOp::ReadEntries);
    if (error || !entries) return ResultOrigin{*command, number, std::nullopt};
    const auto each = static_cast<std::uint32_t>(1 + config.slb_config().entry_words());
    const std::uint32_t word = number % each;
    return ResultOrigin{*command, number / each, word == 0 ? std::nullopt : std::optional(word - 1)};
  }
  return std::nullopt;
}

std::optional<ResultRecord> ResultReader::next() {
  if (offset_ >= words_.size()) return std::nullopt;
  ResultRecord result{.offset = offset_, .word = words_[offset_], .raw = {}};
  if (static_cast<std::uint8_t>(result_code(result.word)) == slb::kEntryCode) {
    const auto rest = words_.subspan(offset_ + 1);
    const std::size_t announced = slb::decode_entry_header(result.word).words;
    result.raw = rest.first(std::min(rest.size(), announced));
  }
  offset_ += 1 + result.raw.size();
  return result;
}

}  // namespace gnomon::golden
