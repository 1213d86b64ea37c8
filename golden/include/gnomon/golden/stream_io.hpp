// SPDX-License-Identifier: Apache-2.0
// Command streams as files: what an engine was built for, and the words it takes.
#pragma once

#include <filesystem>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace gnomon::golden {

/// A file holds, in little-endian: the 8 bytes "GNOMON\x1A\n", uint32 version (5), 23 uint32 (the
/// projection unit's parameters, the silhouette-line buffer's, topology mode's, the frame buffer's,
/// EN_PERSPECTIVE), uint64 number of words, the words. Versions 1 to 4 have the first 7, 15, 20 and 22
/// parameters; they are read too.
struct StreamFile {
  HardwareConfig config;
  std::vector<Word> words;
};

/// Nothing if the file was written; else one line with the path and what failed.
std::optional<std::string> save_stream(const std::filesystem::path& path, const HardwareConfig& config,
                                       std::span<const Word> words);

/// The stream, or one line with the path and what was expected.
std::variant<StreamFile, std::string> load_stream(const std::filesystem::path& path);

}  // namespace gnomon::golden
