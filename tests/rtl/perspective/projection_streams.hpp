// SPDX-License-Identifier: Apache-2.0
// Streams of both modes of the projection unit, for hardware with the perspective projection, and golden's
// answers.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <string>
#include <vector>

namespace gnomon::rtl_test {

/// What CMakeLists.txt builds.
golden::HardwareConfig perspective_build();

struct ProjectionCase {
  std::string name;
  std::vector<golden::Word> words, results;
  std::vector<std::uint64_t> events;  ///< in the order of event_indices
};

/// Directed streams; random ones of offset mode; random ones of topology mode under lights of both kinds.
std::vector<ProjectionCase> projection_cases(int random_streams);

/// Events that golden counts on this hardware: index of the counter port and name.
std::vector<std::pair<unsigned, std::string>> event_indices();

}  // namespace gnomon::rtl_test
