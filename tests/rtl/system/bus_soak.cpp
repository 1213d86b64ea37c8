// SPDX-License-Identifier: Apache-2.0
// bus_soak [faults [first seed]]: random faults of the bus by the thousand, a new hardware every 500; on a
// narrow and a wide bus, and with planes in memory. A line a hardware; status 1 if anything is wrong.
#include <cstdlib>
#include <iostream>

#include "Vsystem_cached.h"
#include "Vsystem_narrow.h"
#include "Vsystem_wide.h"
#include "campaign.hpp"

namespace gnomon::rtl_test {
namespace {

template <class Model>
bool soak(const char* name, const golden::HardwareConfig& config, std::uint32_t seed, unsigned faults) {
  Campaign<Model> campaign(config, seed);
  const Tally& tally = campaign.run(faults);
  std::cout << name << ", seed " << seed << ": " << tally.text() << std::endl;
  return tally.clean() && tally.words != 0;
}

int run(unsigned faults, std::uint32_t seed) {
  constexpr unsigned kEach = 500;
  bool clean = true;
  for (unsigned done = 0; done < faults; done += 3 * kEach, ++seed) {
    clean = soak<Vsystem_narrow>("64 bits", kSmall, seed, kEach) && clean;
    clean = soak<Vsystem_wide>("512 bits", kSmall, seed, kEach) && clean;
    clean = soak<Vsystem_cached>("64 bits, cache", kCached, seed, kEach) && clean;
  }
  return clean ? 0 : 1;
}

}  // namespace
}  // namespace gnomon::rtl_test

int main(int argc, char** argv) {
  const unsigned long faults = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 30'000;
  const unsigned long seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000;
  return gnomon::rtl_test::run(static_cast<unsigned>(faults), static_cast<std::uint32_t>(seed));
}
