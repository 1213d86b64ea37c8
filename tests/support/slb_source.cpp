// SPDX-License-Identifier: Apache-2.0
// Random objects and queries in batches, so that what is asked was drawn a moment ago.
#include "tests/support/slb_source.hpp"

#include "tests/golden/slb/stimulus.hpp"

namespace gnomon::stimulus {

namespace slb = golden::slb::testing;

SlbSource::SlbSource(const golden::HardwareConfig& config, std::uint64_t seed, int max_items,
                     int illegal_percent)
    : config_(config), random_(~seed), max_items_(max_items), illegal_percent_(illegal_percent) {}

std::vector<golden::Word> SlbSource::next() {
  if (at_ == commands_.size()) {
    slb::StimulusOptions options;
    options.objects = 2;
    options.queries = max_items_;
    options.error_share = illegal_percent_ / 100.0;
    options.read_back = random_.chance(30);
    commands_.clear();
    for (const slb::Command& command : random_commands(random_.bits(), config_.slb_config(), options)) {
      commands_.push_back(slb::to_words({command}));
    }
    at_ = 0;
  }
  return commands_[at_++];
}

}  // namespace gnomon::stimulus
