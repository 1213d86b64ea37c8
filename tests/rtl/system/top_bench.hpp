// SPDX-License-Identifier: Apache-2.0
// A Verilated gnomon_top with memory behind it and software in front of it: register accesses, rings, jobs.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "axi_memory.hpp"
#include "sim/registers/registers.hpp"
#include "tests/rtl/clocked_model.hpp"

namespace gnomon::rtl_test {

namespace hw = sim::registers::hardware;
using golden::Word;

struct Rings {
  std::uint64_t base = 0x8000'0000;  ///< of the memory
  std::uint32_t command_log2 = 4, result_log2 = 9;
  std::uint64_t commands() const { return base; }
  std::uint64_t results() const { return base + 0x10000; }
  std::uint64_t words() const { return base + 0x20000; }  ///< of the jobs
};

struct Completion {
  std::uint32_t results, flags, errors;
  std::uint16_t job, state;
};

/// What a register access was answered.
struct Access {
  std::uint32_t value;
  unsigned response;
};

template <class Model>
class TopBench {
 public:
  static constexpr unsigned kBeatBytes = sizeof(Model::m_axi_rdata_i);
  static constexpr std::size_t kMemoryBytes = 0x200000;

  explicit TopBench(std::uint32_t seed, const std::string& plusarg = {})
      : model_(seed, plusarg),
        memory_(Rings{}.base, kMemoryBytes, kBeatBytes, seed ^ 0xBEEFu),
        random_(seed) {
    model_.survive_assertions();
    model_->s_axil_awvalid_i = model_->s_axil_wvalid_i = model_->s_axil_arvalid_i = 0;
    model_->s_axil_bready_i = model_->s_axil_rready_i = 0;
    model_->s_axis_tvalid_i = model_->m_axis_tready_i = 0;
    model_->m_axi_rvalid_i = model_->m_axi_bvalid_i = 0;
    model_.reset();
  }

  AxiMemory& memory() { return memory_; }
  Model& model() { return *model_; }
  const Rings& rings() const { return rings_; }
  bool interrupt() const { return model_->irq_o != 0; }
  /// An assertion of the hardware has failed.
  bool asserted() const { return model_.asserted(); }
  std::uint64_t cycles() const { return cycles_; }

  /// One clock cycle, memory included.
  void clock() {
    memory_.drive(*model_);
    model_.settle();
    memory_.sample(*model_);
    model_.rise();
    ++cycles_;
  }
  void run(std::uint64_t cycles) {
    for (std::uint64_t i = 0; i < cycles; ++i) clock();
  }

  unsigned write(std::uint32_t offset, std::uint32_t value, unsigned strobe = 15) {
    const unsigned address_first = random_() % 4, data_first = random_() % 4;
    model_->s_axil_awaddr_i = static_cast<SData>(offset);
    model_->s_axil_wdata_i = value;
    model_->s_axil_wstrb_i = static_cast<CData>(strobe);
    model_->s_axil_bready_i = 1;
    bool address_left = true, data_left = true;
    for (unsigned i = 0;; ++i) {
      if (i > kAccessCycles) throw std::runtime_error("a register write is not answered");
      model_->s_axil_awvalid_i = address_left && i >= address_first;
      model_->s_axil_wvalid_i = data_left && i >= data_first;
      model_.settle();
      const bool answered = model_->s_axil_bvalid_o != 0;
      const unsigned response = model_->s_axil_bresp_o;
      if (model_->s_axil_awvalid_i && model_->s_axil_awready_o) address_left = false;
      if (model_->s_axil_wvalid_i && model_->s_axil_wready_o) data_left = false;
      clock();
      if (!answered) continue;
      model_->s_axil_bready_i = 0;
      return response;
    }
  }

  Access access(std::uint32_t offset) {
    model_->s_axil_araddr_i = static_cast<SData>(offset);
    bool left = true;
    for (unsigned i = 0;; ++i) {
      if (i > kAccessCycles) throw std::runtime_error("a register read is not answered");
      model_->s_axil_arvalid_i = left;
      model_->s_axil_rready_i = random_() % 2;
      model_.settle();
      const bool answered = model_->s_axil_rvalid_o && model_->s_axil_rready_i;
      const Access result{model_->s_axil_rdata_o, model_->s_axil_rresp_o};
      if (model_->s_axil_arvalid_i && model_->s_axil_arready_o) left = false;
      clock();
      if (answered) {
        model_->s_axil_rready_i = 0;
        return result;
      }
    }
  }
  std::uint32_t read(std::uint32_t offset) { return access(offset).value; }

  /// Rings as after power-up or reset, all interrupts enabled.
  void start(const Rings& rings, std::uint32_t timeout, std::uint32_t result_count = 0) {
    rings_ = rings;
    head_ = 0;
    taken_ = result_count;
    write(hw::kControlOffset, 0);
    write_address(hw::kCommandBaseLowOffset, rings.commands());
    write_address(hw::kResultBaseLowOffset, rings.results());
    write_address(hw::kPlaneBaseLowOffset, rings.base + 0x60000);
    write(hw::kCommandSizeOffset, rings.command_log2);
    write(hw::kResultSizeOffset, rings.result_log2);
    write(hw::kResultHeadOffset, result_count);
    write(hw::kResultTailOffset, result_count);
    write(hw::kAxiTimeoutOffset, timeout);
    write(hw::kInterruptEnableOffset, 7);
    write(hw::kControlOffset, hw::kControlEnableMask);
  }

  /// Puts a job into memory, cut into descriptors at random; returns the last one's place.
  std::uint32_t submit(std::span<const Word> words, std::uint16_t job, unsigned descriptors,
                       unsigned misalign = 0) {
    std::uint64_t address = rings_.words() + 8ULL * misalign;
    std::size_t done = 0;
    for (unsigned i = 0; i < descriptors; ++i) {
      const bool last = i + 1 == descriptors;
      const std::size_t left = words.size() - done, others = descriptors - i - 1;
      const std::size_t count = last ? left : 1 + random_() % (left - others);
      for (std::size_t w = 0; w < count; ++w) memory_.set_word(address + 8 * w, words[done + w]);
      put_descriptor(address, static_cast<std::uint32_t>(count), job, last ? 3 : 0);
      address += 8 * (count + random_() % 9);
      done += count;
    }
    write(hw::kCommandHeadOffset, head_);
    return head_ - 1;
  }
  void put_descriptor(std::uint64_t address, std::uint32_t count, std::uint16_t job, std::uint16_t flags) {
    const std::uint64_t place = place_address(head_++);
    memory_.set_word(place, address);
    memory_.set_word(place + 8, count | std::uint64_t{job} << 32 | std::uint64_t{flags} << 48);
  }
  std::uint32_t head() const { return head_; }

  Completion completion(std::uint32_t place) const {
    const std::uint64_t low = memory_.word(place_address(place)),
                        high = memory_.word(place_address(place) + 8);
    return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
            static_cast<std::uint32_t>(high), static_cast<std::uint16_t>(high >> 32),
            static_cast<std::uint16_t>(high >> 48)};
  }

  /// Results that the head says are there, and the ring's places given back.
  void take_results(std::vector<Word>& results) {
    const std::uint32_t head = read(hw::kResultHeadOffset), mask = (1u << rings_.result_log2) - 1;
    if (head == taken_) return;
    if (head - taken_ > mask + 1) throw std::runtime_error("the result ring's head is beyond its size");
    for (; taken_ != head; ++taken_)
      results.push_back(memory_.word(rings_.results() + 8ULL * (taken_ & mask)));
    write(hw::kResultTailOffset, taken_);
  }

  /// Waits for the interrupt line, taking results in between. False after so many cycles without.
  bool wait(std::vector<Word>& results, std::uint64_t limit = 200'000) {
    const std::uint64_t end = cycles_ + limit;
    while (cycles_ < end && !asserted()) {
      const std::uint32_t status = read(hw::kInterruptStatusOffset);
      write(hw::kInterruptStatusOffset, status);
      take_results(results);
      if ((status & (hw::kInterruptStatusJobDoneMask | hw::kInterruptStatusErrorMask)) != 0) return true;
      for (int i = 0; i < 200 && !interrupt(); ++i) clock();
    }
    return false;
  }

  bool stopped() { return (read(hw::kStatusOffset) & hw::kStatusStoppedMask) != 0; }

  /// False if the reset does not end.
  bool reset(std::uint64_t limit = 200'000) {
    write(hw::kResetOffset, hw::kResetSoftResetMask);
    const std::uint64_t end = cycles_ + limit;
    while (read(hw::kResetOffset) != 0) {
      if (cycles_ > end) return false;
    }
    return true;
  }

  std::uint64_t counter(unsigned index) {
    const std::uint64_t high = read(hw::kCounterHighOffset + index * hw::kCounterHighStride);
    return read(hw::kCounterLowOffset + index * hw::kCounterLowStride) | high << 32;
  }

 private:
  static constexpr unsigned kAccessCycles = 100;

  void write_address(std::uint32_t low_offset, std::uint64_t address) {
    write(low_offset, static_cast<std::uint32_t>(address));
    write(low_offset + 4, static_cast<std::uint32_t>(address >> 32));
  }
  std::uint64_t place_address(std::uint32_t place) const {
    return rings_.commands() + 16ULL * (place & ((1u << rings_.command_log2) - 1));
  }

  ClockedModel<Model> model_;
  AxiMemory memory_;
  std::mt19937 random_;
  Rings rings_;
  std::uint32_t head_ = 0, taken_ = 0;
  std::uint64_t cycles_ = 0;
};

}  // namespace gnomon::rtl_test
