// SPDX-License-Identifier: Apache-2.0
// Whole files, and short names for contents so that a cache entry can never be taken for another one's.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace gnomon::sim {

/// 32 hexadecimal digits of SHA-1 over the bytes.
std::string content_hash(std::string_view bytes);

/// Content of a file. Throws std::runtime_error, naming the file, if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Throws std::runtime_error, naming the file, if it cannot be written.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace gnomon::sim
