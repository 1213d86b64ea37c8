// SPDX-License-Identifier: Apache-2.0
// Images to and from PNG files.
#pragma once

#include <filesystem>

#include "host/base/result.hpp"
#include "host/render/picture.hpp"

namespace gnomon::render {

/// Writes a temporary file beside `path` and renames it: either the whole picture is there or nothing.
Result<void> write_png(const Image& image, const std::filesystem::path& path);
/// 8-bit RGB; anything else is converted to it.
Result<Image> read_png(const std::filesystem::path& path);

}  // namespace gnomon::render
