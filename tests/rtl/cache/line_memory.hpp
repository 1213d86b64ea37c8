// SPDX-License-Identifier: Apache-2.0
// A memory behind a line port (docs/cache.md): as slow, as unsteady and as much out of order as asked for,
// and it watches the rules that the port has.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <unordered_map>
#include <vector>

namespace gnomon::rtl_test {

/// All times in cycles.
struct LineTiming {
  std::uint32_t latency = 20;  ///< from the request to its line, or from the write to its answer, at least
  std::uint32_t spread = 0;    ///< up to this much more, another for each: lines come out of order
  std::uint32_t cycles_per_line = 1;  ///< of the bus, each way
  std::uint32_t open_per_256 = 256;   ///< chance that a request is taken in a cycle
};

/// What went over the port.
struct LineTraffic {
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

class LineMemory {
 public:
  using Line = std::array<std::uint32_t, 16>;

  explicit LineMemory(const LineTiming& timing = {}, std::uint32_t seed = 1)
      : timing_(timing), random_(seed) {}

  /// Sets the inputs of the port, before the model is evaluated in a cycle.
  template <class Model>
  void drive(Model& model) {
    Port port{model.lines_i};
    port.set(kReadReady, open());
    port.set(kWriteReady, open());
    data_ = next_due(reads_, bus_free_);
    port.set(kDataValid, data_.has_value());
    if (data_) {
      const Pending& read = reads_[*data_];
      port.set(kDataId, read.id);
      const Line line = content(read.address);
      for (std::size_t i = 0; i < line.size(); ++i) model.lines_i[i] = line[i];
    }
    written_ = next_due(writes_, 0);
    port.set(kWrittenValid, written_.has_value());
    if (written_) port.set(kWrittenId, writes_[*written_].id);
  }

  /// Takes what the model gives, after it was evaluated and before its clock rises.
  template <class Model>
  void clock(Model& model) {
    if (data_) {
      bus_free_ = now_ + timing_.cycles_per_line;
      reads_.erase(reads_.begin() + static_cast<std::ptrdiff_t>(*data_));
    }
    if (written_) {
      const Pending& write = writes_[*written_];
      lines_[write.address] = write.line;
      writes_.erase(writes_.begin() + static_cast<std::ptrdiff_t>(*written_));
    }
    const Port out{model.lines_o};
    const Port in{model.lines_i};
    if (out.get(kReadValid) != 0 && in.get(kReadReady) != 0)
      take_read(out.get(kReadLine), static_cast<std::uint32_t>(out.get(kReadId)));
    if (out.get(kWriteValid) != 0 && in.get(kWriteReady) != 0) {
      Line line{};
      for (std::size_t i = 0; i < line.size(); ++i) line[i] = model.lines_o[i];
      take_write(out.get(kWriteLine), static_cast<std::uint32_t>(out.get(kWriteId)), line);
    }
    ++now_;
  }

  /// Forgets what is under way, as a reset does; what it holds stays.
  void reset() {
    reads_.clear();
    writes_.clear();
    data_ = written_ = std::nullopt;
  }

  const LineTraffic& traffic() const { return traffic_; }
  /// The first broken rule, or empty.
  const std::string& broken() const { return broken_; }

 private:
  /// Bits of port_want_t and port_give_t of cache_pkg, above the line's.
  struct Bits {
    unsigned from, count;
  };
  static constexpr Bits kWriteId{512, 5}, kWriteLine{517, 58}, kWriteValid{575, 1}, kReadId{576, 5},
      kReadLine{581, 58}, kReadValid{639, 1};
  static constexpr Bits kWrittenId{512, 5}, kWrittenValid{517, 1}, kDataId{518, 5}, kDataValid{523, 1},
      kWriteReady{524, 1}, kReadReady{525, 1};
  /// A port of many bits, in words of 32.
  template <class Words>
  struct Port {
    explicit Port(Words& all) : words(all) {}
    Words& words;
    std::uint64_t get(const Bits& bits) const {
      std::uint64_t value = 0;
      for (unsigned i = 0; i < bits.count; ++i)
        value |= std::uint64_t{words[(bits.from + i) / 32] >> (bits.from + i) % 32 & 1u} << i;
      return value;
    }
    void set(const Bits& bits, std::uint64_t value) {
      for (unsigned i = 0; i < bits.count; ++i) {
        const std::uint32_t bit = std::uint32_t{1} << (bits.from + i) % 32;
        if ((value >> i & 1u) != 0)
          words[(bits.from + i) / 32] |= bit;
        else
          words[(bits.from + i) / 32] &= ~bit;
      }
    }
  };
  struct Pending {
    std::uint64_t address = 0;
    std::uint32_t id = 0;
    std::uint64_t due = 0;
    Line line{};  // of a write
  };

  bool open() { return timing_.open_per_256 >= 256 || (random_() & 255u) < timing_.open_per_256; }
  std::uint64_t due() {
    const std::uint32_t more =
        timing_.spread == 0 ? 0 : static_cast<std::uint32_t>(random_()) % (timing_.spread + 1);
    return now_ + timing_.latency + more;
  }
  void fault(const std::string& what) {
    if (broken_.empty()) broken_ = what + " in cycle " + std::to_string(now_);
  }

  void take_read(std::uint64_t address, std::uint32_t id) {
    for (const Pending& read : reads_) {
      if (read.id == id) fault("a read with an id that is under way");
    }
    for (const Pending& write : writes_) {
      if (write.address == address) fault("a read of a line that is being written");
    }
    if (!lines_.contains(address)) fault("a read of a line that was never written");
    reads_.push_back({.address = address, .id = id, .due = due(), .line = {}});
    ++traffic_.reads;
  }
  void take_write(std::uint64_t address, std::uint32_t id, const Line& line) {
    for (const Pending& write : writes_) {
      if (write.id == id) fault("a write with an id that is under way");
      if (write.address == address) fault("two writes of a line at the same time");
    }
    // Writes go over the bus one after the other.
    write_bus_free_ = std::max(write_bus_free_, now_) + timing_.cycles_per_line;
    writes_.push_back({.address = address, .id = id, .due = std::max(due(), write_bus_free_), .line = line});
    ++traffic_.writes;
  }

  /// What was never written is noise, so that whoever uses it is found out.
  Line content(std::uint64_t address) {
    const auto found = lines_.find(address);
    if (found != lines_.end()) return found->second;
    Line noise{};
    for (std::uint32_t& word : noise) word = static_cast<std::uint32_t>(random_());
    return noise;
  }

  /// The one of `pending` that is due first, once it is due and the bus is free.
  std::optional<std::size_t> next_due(const std::vector<Pending>& pending, std::uint64_t bus_free) const {
    if (now_ < bus_free) return std::nullopt;
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (pending[i].due <= now_ && (!first || pending[i].due < pending[*first].due)) first = i;
    }
    return first;
  }

  LineTiming timing_;
  std::mt19937 random_;
  std::unordered_map<std::uint64_t, Line> lines_;
  std::vector<Pending> reads_, writes_;
  std::optional<std::size_t> data_, written_;  // on offer in this cycle
  std::uint64_t now_ = 0, bus_free_ = 0, write_bus_free_ = 0;
  LineTraffic traffic_;
  std::string broken_;
};

}  // namespace gnomon::rtl_test
