// SPDX-License-Identifier: Apache-2.0
// Drives one Verilated gnomon_top behind top_abi.h. The cache compiles this file together with what Verilator
// wrote.
#include <algorithm>
#include <array>
#include <cstring>
#include <deque>

#include "Vgnomon_top.h"
#include "top_abi.h"
#include "verilated_top.hpp"

namespace {

constexpr uint32_t kBeat = sizeof(Vgnomon_top::m_axi_wdata_o);  // bytes of a beat

/// A read's answer on its way back.
struct ReadAnswer {
  uint64_t cycle = 0;
  uint32_t id = 0, bytes = 0, given = 0;
  int response = 0;
  std::array<uint8_t, GNOMON_TOP_BURST_BYTES> data;
};
struct WriteAnswer {
  uint64_t cycle = 0;
  uint32_t id = 0;
  int response = 0;
};
struct WriteAddress {
  uint64_t address = 0;
  uint32_t id = 0;
};
/// A write's beats, which may come before its address.
struct WriteData {
  uint64_t cycle = 0;
  uint32_t bytes = 0;
  uint64_t strobe = 0;
  std::array<uint8_t, GNOMON_TOP_LINE_BYTES> data;
};

class Model : public VerilatedTop<Vgnomon_top, GNOMON_TOP_RESET_CYCLES> {
 public:
  explicit Model(uint32_t seed) : VerilatedTop("gnomon_top", seed, 2) { power_up(); }

  int run(uint64_t until) {
    enter();
    return tracing() ? run_loop<true>(until) : run_loop<false>(until);
  }
  bool interrupt() const { return interrupt_; }

  void begin_access(bool is_write, uint32_t offset, uint32_t data) {
    Vgnomon_top& top = *top_;
    accessing_ = true;
    if (is_write) {
      top.s_axil_awvalid_i = top.s_axil_wvalid_i = 1;
      top.s_axil_awaddr_i = static_cast<SData>(offset);
      top.s_axil_wdata_i = data;
      top.s_axil_wstrb_i = 15;
    } else {
      top.s_axil_arvalid_i = 1;
      top.s_axil_araddr_i = static_cast<SData>(offset);
    }
  }
  int end_access(uint32_t* data) const {
    *data = access_data_;
    return access_response_;
  }

  bool take_read(GnomonTopRead& read) {
    if (reads_.empty()) return false;
    read = reads_.front();
    reads_.pop_front();
    return true;
  }

  bool take_write(GnomonTopWrite& write) {
    if (addresses_.empty() || !whole_) return false;
    const WriteAddress& address = addresses_.front();
    const WriteData& data = written_.front();
    write = {data.cycle, address.address, address.id, data.bytes, {}, data.strobe};
    std::memcpy(write.data, data.data.data(), sizeof write.data);
    addresses_.pop_front();
    written_.pop_front();
    --whole_;
    return true;
  }

  void answer_read(const GnomonTopRead& read, uint64_t cycle, const uint8_t* data, int response) {
    ReadAnswer& answer = read_answers_.emplace_back();
    answer.cycle = cycle;
    answer.id = read.id;
    answer.bytes = read.bytes;
    answer.response = response;
    std::memcpy(answer.data.data(), data, read.bytes);
  }
  void answer_write(const GnomonTopWrite& write, uint64_t cycle, int response) {
    write_answers_.push_back({cycle, write.id, response});
  }

 private:
  void power_up() {
    Vgnomon_top& top = *top_;
    top.s_axil_awvalid_i = top.s_axil_wvalid_i = top.s_axil_arvalid_i = 0;
    top.s_axil_bready_i = top.s_axil_rready_i = 1;
    top.s_axis_tvalid_i = 0;
    top.m_axis_tready_i = 0;
    top.m_axi_arready_i = top.m_axi_awready_i = top.m_axi_wready_i = 1;
    top.m_axi_rvalid_i = top.m_axi_bvalid_i = 0;
    hold_reset();
  }

  /// What memory offers in this cycle.
  void drive_answers() {
    Vgnomon_top& top = *top_;
    const bool read = !read_answers_.empty() && read_answers_.front().cycle <= cycle_;
    top.m_axi_rvalid_i = read;
    if (read) {
      const ReadAnswer& answer = read_answers_.front();
      top.m_axi_rid_i = static_cast<CData>(answer.id);
      top.m_axi_rresp_i = static_cast<CData>(answer.response);
      top.m_axi_rlast_i = answer.given + kBeat >= answer.bytes;
      std::memcpy(&top.m_axi_rdata_i, answer.data.data() + answer.given, kBeat);
    }
    const bool written = !write_answers_.empty() && write_answers_.front().cycle <= cycle_;
    top.m_axi_bvalid_i = written;
    if (written) {
      top.m_axi_bid_i = static_cast<CData>(write_answers_.front().id);
      top.m_axi_bresp_i = static_cast<CData>(write_answers_.front().response);
    }
  }

  /// Moves of the memory's channels in this cycle.
  int sample_memory() {
    Vgnomon_top& top = *top_;
    if (top.m_axi_rvalid_i && top.m_axi_rready_o) {
      ReadAnswer& answer = read_answers_.front();
      answer.given += kBeat;
      if (answer.given >= answer.bytes) read_answers_.pop_front();
    }
    if (top.m_axi_bvalid_i && top.m_axi_bready_o) write_answers_.pop_front();
    int events = 0;
    if (top.m_axi_arvalid_o) {
      const uint32_t beats = top.m_axi_arlen_o + 1u;
      reads_.push_back({cycle_, top.m_axi_araddr_o, top.m_axi_araddr_o & ~uint64_t{kBeat - 1},
                        top.m_axi_arid_o, beats, beats * kBeat});
      events |= GNOMON_TOP_READ;
    }
    if (top.m_axi_awvalid_o)
      addresses_.push_back({top.m_axi_awaddr_o & ~uint64_t{kBeat - 1}, top.m_axi_awid_o});
    if (top.m_axi_wvalid_o) take_beat();
    if (whole_ && !addresses_.empty()) events |= GNOMON_TOP_WRITE;
    return events;
  }

  void take_beat() {
    Vgnomon_top& top = *top_;
    if (written_.size() == whole_) written_.emplace_back();
    WriteData& data = written_.back();
    if (data.bytes + kBeat <= data.data.size()) {
      std::memcpy(data.data.data() + data.bytes, &top.m_axi_wdata_o, kBeat);
      data.strobe |= uint64_t{top.m_axi_wstrb_o} << data.bytes;
      data.bytes += kBeat;
    }
    if (!top.m_axi_wlast_o) return;
    data.cycle = cycle_;
    ++whole_;
  }

  /// Moves of the registers' channels in this cycle. What was taken is withdrawn after the clock's edge.
  int sample_access(bool (&taken)[3]) {
    Vgnomon_top& top = *top_;
    taken[0] = top.s_axil_awvalid_i && top.s_axil_awready_o;
    taken[1] = top.s_axil_wvalid_i && top.s_axil_wready_o;
    taken[2] = top.s_axil_arvalid_i && top.s_axil_arready_o;
    if (top.s_axil_bvalid_o) {
      access_response_ = top.s_axil_bresp_o;
    } else if (top.s_axil_rvalid_o) {
      access_response_ = top.s_axil_rresp_o;
      access_data_ = top.s_axil_rdata_o;
    } else {
      return 0;
    }
    accessing_ = false;
    return GNOMON_TOP_ACCESS;
  }

  void withdraw(const bool (&taken)[3]) {
    Vgnomon_top& top = *top_;
    if (taken[0]) top.s_axil_awvalid_i = 0;
    if (taken[1]) top.s_axil_wvalid_i = 0;
    if (taken[2]) top.s_axil_arvalid_i = 0;
  }

  template <bool kTrace>
  int run_loop(uint64_t until) {
    Vgnomon_top& top = *top_;
    int events = 0;
    while (events == 0 && cycle_ < until) {
      drive_answers();
      top.clk_i = 0;
      top.eval();
      dump<kTrace>(0);
      events = sample_memory();
      bool taken[3] = {false, false, false};
      if (accessing_) events |= sample_access(taken);
      if (interrupt_ != (top.irq_o != 0)) {
        interrupt_ = !interrupt_;
        events |= GNOMON_TOP_INTERRUPT;
      }
      top.clk_i = 1;
      top.eval();
      dump<kTrace>(1);
      withdraw(taken);
      ++cycle_;
      if (__builtin_expect(context_.gotFinish() || context_.gotError(), 0)) events |= GNOMON_TOP_FAULT;
    }
    return events;
  }

  bool interrupt_ = false;
  bool accessing_ = false;
  int access_response_ = 0;
  uint32_t access_data_ = 0;
  std::deque<GnomonTopRead> reads_;
  std::deque<WriteAddress> addresses_;
  std::deque<WriteData> written_;  // the last of them may not be whole
  size_t whole_ = 0;               // of those
  std::deque<ReadAnswer> read_answers_;
  std::deque<WriteAnswer> write_answers_;
};

Model& model_of(void* model) {
  return *static_cast<Model*>(model);
}
const Model& model_of(const void* model) {
  return *static_cast<const Model*>(model);
}

const GnomonTopApi kApi = {
    GNOMON_TOP_ABI,
    [](uint32_t seed) -> void* { return new Model(seed); },
    [](void* m) { delete static_cast<Model*>(m); },
    [](void* m, uint64_t until) { return model_of(m).run(until); },
    [](const void* m) { return model_of(m).cycle(); },
    [](const void* m) { return model_of(m).interrupt() ? 1 : 0; },
    [](void* m) { return model_of(m).fault(); },
    [](void* m, int is_write, uint32_t offset, uint32_t data) {
      model_of(m).begin_access(is_write != 0, offset, data);
    },
    [](void* m, uint32_t* data) { return model_of(m).end_access(data); },
    [](void* m, GnomonTopRead* read) { return model_of(m).take_read(*read) ? 1 : 0; },
    [](void* m, GnomonTopWrite* write) { return model_of(m).take_write(*write) ? 1 : 0; },
    [](void* m, const GnomonTopRead* read, uint64_t cycle, const uint8_t* data, int response) {
      model_of(m).answer_read(*read, cycle, data, response);
    },
    [](void* m, const GnomonTopWrite* write, uint64_t cycle, int response) {
      model_of(m).answer_write(*write, cycle, response);
    },
    [](void* m, const char* path, uint64_t from, uint64_t to) {
      return model_of(m).trace_open(path, from, to) ? 1 : 0;
    },
    [](void* m) { model_of(m).trace_close(); },
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const GnomonTopApi* gnomon_top_api(void) {
  return &kApi;
}
