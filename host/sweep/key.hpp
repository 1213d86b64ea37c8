// SPDX-License-Identifier: Apache-2.0
// What a point is known by, in every sweep and on every machine. Theory: docs/sweep.md, "Points and their
// keys".
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/config/settings.hpp"

namespace gnomon::sweep {

/// One hash over the content of all files that a scene is made of, in the order given. Throws
/// std::runtime_error, naming the file, if one cannot be read.
std::string scene_hash(std::span<const std::filesystem::path> files);

/// Keys that were given their default, where that is not the same as giving nothing: a light replaces the
/// scene's own, topology mode has another pitch, and who says anything about the memory asks for the system's
/// cycles.
std::vector<std::string_view> given_defaults(const config::Settings& settings);

/// 32 hexadecimal digits. Parameters that change no figure (threads, size of the picture) are left out.
std::string point_key(std::string_view scene, const config::Settings& settings,
                      std::string_view model_version);

}  // namespace gnomon::sweep
