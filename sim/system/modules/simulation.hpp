// SPDX-License-Identifier: Apache-2.0
// A SystemC simulation of its own, beside others in the same process.
#pragma once

#include <memory>
#include <mutex>
#include <systemc>

namespace gnomon::sim::system {

/// SystemC has one current simulation, and it cannot be elaborated again once it has run. Each object here is
/// a simulation; whoever uses SystemC for it holds a Turn meanwhile. Turns of several threads wait for each
/// other.
class Simulation {
 public:
  Simulation() : context_(std::make_unique<sc_core::sc_simcontext>()) {}

  class Turn {
   public:
    explicit Turn(const Simulation& simulation)
        : lock_(mutex()), before_(sc_core::sc_curr_simcontext), own_(simulation.context_.get()) {
      use(own_);
    }
    ~Turn() { use(before_); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    std::unique_lock<std::recursive_mutex> lock_;
    sc_core::sc_simcontext* before_;
    sc_core::sc_simcontext* own_;
  };

 private:
  static std::recursive_mutex& mutex() {
    static std::recursive_mutex only;
    return only;
  }
  static void use(sc_core::sc_simcontext* context) {
    sc_core::sc_curr_simcontext = context;
    sc_core::sc_default_global_context = context;
  }

  std::unique_ptr<sc_core::sc_simcontext> context_;
};

}  // namespace gnomon::sim::system
