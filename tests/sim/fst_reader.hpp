// SPDX-License-Identifier: Apache-2.0
// Reads back a waveform, with the reader that Verilator ships beside its writer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::sim::test {

/// What a waveform says about one signal.
struct Edge {
  std::uint64_t time = 0;  ///< ns
  std::string value;       ///< binary digits
  bool operator==(const Edge&) const = default;
};

/// Changes of the top-level signal `name` (e.g. "clk_i"), the first value included. Nothing if the file is no
/// complete FST file or has no such signal.
std::optional<std::vector<Edge>> read_signal(const std::filesystem::path& file, const std::string& name);

}  // namespace gnomon::sim::test
