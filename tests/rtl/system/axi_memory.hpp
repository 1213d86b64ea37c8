// SPDX-License-Identifier: Apache-2.0
// Memory behind AXI for a Verilated master: random delays, answers of different ids in any order and
// interleaved, every channel held back at random, and faults on purpose. What a write changes is changed as
// late as AXI allows: when it is answered.
#pragma once

#include <verilated.h>

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <random>
#include <vector>

namespace gnomon::rtl_test {

inline constexpr std::size_t kMaxBeatBytes = 64, kIds = 128;
using Beat = std::array<std::uint8_t, kMaxBeatBytes>;

inline void set_port(QData& port, const Beat& beat) {
  std::memcpy(&port, beat.data(), sizeof port);
}
inline Beat get_port(const QData& port) {
  Beat beat{};
  std::memcpy(beat.data(), &port, sizeof port);
  return beat;
}
template <std::size_t kWords>
void set_port(VlWide<kWords>& port, const Beat& beat) {
  std::memcpy(&port[0], beat.data(), kWords * sizeof(EData));
}
template <std::size_t kWords>
Beat get_port(const VlWide<kWords>& port) {
  Beat beat{};
  std::memcpy(beat.data(), &port[0], kWords * sizeof(EData));
  return beat;
}

/// Something that goes wrong with one transaction.
enum class Fault : std::uint8_t {
  None,
  ReadSlverr,
  ReadDecerr,
  WriteSlverr,
  WriteDecerr,
  ReadSilent,   ///< not answered before `heal`
  WriteSilent,  ///< likewise
  ReadAddressStuck,
  WriteAddressStuck,
  WriteDataStuck,  ///< channels that take nothing before `heal`
};

struct MemoryTiming {
  unsigned min_delay = 1, max_delay = 1;  ///< cycles from the address, or the last beat, to the answer
  unsigned open = 256;                    ///< chance in 256 that a channel moves in a cycle
  bool reorder = false;                   ///< among ids, and beats of reads interleaved
};

class AxiMemory {
 public:
  AxiMemory(std::uint64_t base, std::size_t bytes, unsigned beat_bytes, std::uint32_t seed)
      : base_(base), bytes_(bytes), beat_bytes_(beat_bytes), random_(seed) {}

  void set_timing(const MemoryTiming& timing) { timing_ = timing; }
  /// The fault happens to the read or write (as its kind says) after `skip` others.
  void inject(Fault fault, unsigned skip) {
    fault_ = fault;
    skip_ = skip;
    address_ = 0;
  }
  /// A fault that has not happened will not.
  void disarm() { fault_ = Fault::None; }
  /// Stuck channels move again, silent transactions are answered.
  void heal() {
    fault_ = Fault::None;
    stuck_ = Fault::None;
    for (Read& read : reads_) read.silent = false;
    for (Answer& answer : answers_) answer.silent = false;
  }
  bool happened() const { return address_ != 0; }
  std::uint64_t fault_address() const { return address_; }  ///< of the transaction that it happened to
  std::uint64_t beats() const { return beats_; }
  bool quiet() const { return reads_.empty() && writes_.empty() && answers_.empty(); }

  std::uint64_t word(std::uint64_t address) const {
    std::uint64_t value = 0;
    std::memcpy(&value, &bytes_.at(address - base_), sizeof value);
    return value;
  }
  void set_word(std::uint64_t address, std::uint64_t value) {
    std::memcpy(&bytes_.at(address - base_), &value, sizeof value);
  }

  /// Before the clock edge: what the memory offers.
  template <class Model>
  void drive(Model& model) {
    model.m_axi_arready_i = stuck_ != Fault::ReadAddressStuck && open();
    model.m_axi_awready_i = stuck_ != Fault::WriteAddressStuck && open();
    model.m_axi_wready_i = stuck_ != Fault::WriteDataStuck && !addresses_late() && open();
    if (!offering_read_ && open()) choose_read();
    model.m_axi_rvalid_i = offering_read_;
    if (offering_read_) {
      const Read& read = reads_[chosen_read_];
      model.m_axi_rid_i = static_cast<CData>(read.id);
      model.m_axi_rresp_i = static_cast<CData>(read.response);
      model.m_axi_rlast_i = read.beat == read.length;
      set_port(model.m_axi_rdata_i, beat_at(read.address + std::uint64_t{read.beat} * beat_bytes_));
    }
    if (!offering_answer_ && open()) choose_answer();
    model.m_axi_bvalid_i = offering_answer_;
    if (offering_answer_) {
      model.m_axi_bid_i = static_cast<CData>(answers_[chosen_answer_].id);
      model.m_axi_bresp_i = static_cast<CData>(answers_[chosen_answer_].response);
    }
  }

  /// After evaluation: what has moved.
  template <class Model>
  void sample(Model& model) {
    ++cycle_;
    if (model.m_axi_arvalid_o && model.m_axi_arready_i)
      take_read(model.m_axi_arid_o, model.m_axi_araddr_o, model.m_axi_arlen_o);
    if (model.m_axi_rvalid_i && model.m_axi_rready_o) give_beat();
    if (model.m_axi_wvalid_o && model.m_axi_wready_i) {
      data_.push_back({get_port(model.m_axi_wdata_o), model.m_axi_wstrb_o, model.m_axi_wlast_o != 0});
      ++beats_;
    }
    if (model.m_axi_awvalid_o && model.m_axi_awready_i)
      take_write(model.m_axi_awid_o, model.m_axi_awaddr_o, model.m_axi_awlen_o);
    finish_writes();
    if (model.m_axi_bvalid_i && model.m_axi_bready_o) give_answer();
  }

 private:
  struct Read {
    unsigned id, length, beat, response;
    std::uint64_t address, ready;
    bool silent;
  };
  struct Write {
    unsigned id, length;
    std::uint64_t address;
  };
  struct Data {
    Beat bytes;
    std::uint64_t strobe;
    bool last;
  };
  struct Answer {
    unsigned id, response;
    std::uint64_t address, ready;
    std::vector<Data> data;
    bool silent;
  };

  bool open() { return timing_.open >= 256 || (random_() & 255u) < timing_.open; }
  std::uint64_t delay() {
    return timing_.min_delay + random_() % (timing_.max_delay - timing_.min_delay + 1);
  }
  /// Data may come before their address, but not a whole burst more.
  bool addresses_late() const { return writes_.empty() && data_.size() >= 64; }

  Beat beat_at(std::uint64_t address) const {
    Beat beat{};
    if (address >= base_ && address + beat_bytes_ <= base_ + bytes_.size())
      std::memcpy(beat.data(), &bytes_[address - base_], beat_bytes_);
    return beat;
  }

  /// Whether the fault happens to this transaction, one of those it may happen to.
  bool struck(std::uint64_t address) {
    if (skip_-- != 0) return false;
    address_ = address;
    return true;
  }

  void take_read(unsigned id, std::uint64_t address, unsigned length) {
    Read read{id, length, 0, 0, address, cycle_ + delay(), false};
    const bool of_reads = fault_ == Fault::ReadSlverr || fault_ == Fault::ReadDecerr ||
                          fault_ == Fault::ReadSilent || fault_ == Fault::ReadAddressStuck;
    if (of_reads && struck(address)) {
      if (fault_ == Fault::ReadSlverr) read.response = 2;
      if (fault_ == Fault::ReadDecerr) read.response = 3;
      read.silent = fault_ == Fault::ReadSilent;
      if (fault_ == Fault::ReadAddressStuck) stuck_ = fault_;
      fault_ = Fault::None;
    }
    reads_.push_back(read);
  }

  void take_write(unsigned id, std::uint64_t address, unsigned length) {
    writes_.push_back({id, length, address});
  }

  /// The burst whose address and data are all there waits for its answer.
  void finish_writes() {
    while (!writes_.empty() && data_.size() > writes_.front().length) {
      const Write write = writes_.front();
      writes_.pop_front();
      Answer answer{write.id, 0, write.address, cycle_ + delay(), {}, false};
      for (unsigned i = 0; i <= write.length; ++i) {
        answer.data.push_back(data_.front());
        data_.pop_front();
      }
      const bool of_writes = fault_ == Fault::WriteSlverr || fault_ == Fault::WriteDecerr ||
                             fault_ == Fault::WriteSilent || fault_ == Fault::WriteAddressStuck ||
                             fault_ == Fault::WriteDataStuck;
      if (of_writes && struck(write.address)) {
        if (fault_ == Fault::WriteSlverr) answer.response = 2;
        if (fault_ == Fault::WriteDecerr) answer.response = 3;
        answer.silent = fault_ == Fault::WriteSilent;
        if (fault_ == Fault::WriteAddressStuck || fault_ == Fault::WriteDataStuck) stuck_ = fault_;
        fault_ = Fault::None;
      }
      answers_.push_back(std::move(answer));
    }
  }

  /// The first of its id, its time come.
  template <class Queue>
  bool choose(const Queue& queue, std::size_t& chosen) {
    std::bitset<kIds> seen;
    std::vector<std::size_t> ready;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (seen.test(queue[i].id)) continue;
      seen.set(queue[i].id);
      if (!queue[i].silent && queue[i].ready <= cycle_) ready.push_back(i);
      if (!timing_.reorder) break;
    }
    if (ready.empty()) return false;
    chosen = ready[ready.size() == 1 ? 0 : random_() % ready.size()];
    return true;
  }
  void choose_read() {
    // Without reordering a burst that has begun goes on.
    offering_read_ = choose(reads_, chosen_read_);
  }
  void choose_answer() {
    offering_answer_ = choose(answers_, chosen_answer_);
    if (offering_answer_ && answers_[chosen_answer_].response == 0) apply(answers_[chosen_answer_]);
  }
  void apply(const Answer& answer) {
    std::uint64_t address = answer.address;
    for (const Data& data : answer.data) {
      for (unsigned i = 0; i < beat_bytes_; ++i) {
        if ((data.strobe >> i & 1u) != 0) bytes_.at(address + i - base_) = data.bytes[i];
      }
      address += beat_bytes_;
    }
  }
  void give_beat() {
    ++beats_;
    Read& read = reads_[chosen_read_];
    if (read.beat == read.length)
      reads_.erase(reads_.begin() + static_cast<std::ptrdiff_t>(chosen_read_));
    else
      ++read.beat;
    offering_read_ = false;
  }
  void give_answer() {
    answers_.erase(answers_.begin() + static_cast<std::ptrdiff_t>(chosen_answer_));
    offering_answer_ = false;
  }

  std::uint64_t base_;
  std::vector<std::uint8_t> bytes_;
  unsigned beat_bytes_;
  std::mt19937 random_;
  MemoryTiming timing_;
  std::deque<Read> reads_;
  std::deque<Write> writes_;
  std::deque<Data> data_;
  std::deque<Answer> answers_;
  bool offering_read_ = false, offering_answer_ = false;
  std::size_t chosen_read_ = 0, chosen_answer_ = 0;
  std::uint64_t cycle_ = 0, beats_ = 0;
  Fault fault_ = Fault::None, stuck_ = Fault::None;
  unsigned skip_ = 0;
  std::uint64_t address_ = 0;
};

}  // namespace gnomon::rtl_test
