// SPDX-License-Identifier: Apache-2.0
// Tells of every change of an interrupt line.
#pragma once

#include <functional>
#include <systemc>
#include <utility>

namespace gnomon::sim::system {

class LineWatch : public sc_core::sc_module {
 public:
  LineWatch(const sc_core::sc_module_name& name, std::function<void(bool)> on_change)
      : sc_module(name), line("line"), on_change_(std::move(on_change)) {
    SC_HAS_PROCESS(LineWatch);
    SC_METHOD(tell);
    sensitive << line;
    dont_initialize();
  }

  sc_core::sc_in<bool> line;

 private:
  void tell() { on_change_(line.read()); }

  std::function<void(bool)> on_change_;
};

}  // namespace gnomon::sim::system
