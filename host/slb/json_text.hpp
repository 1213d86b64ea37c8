// SPDX-License-Identifier: Apache-2.0
// JSON with the place inside its tree where reading it fails.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::slb {

/// One step into a JSON tree: a key or an index.
using JsonStep = std::variant<std::string, std::size_t>;
using JsonPath = std::vector<JsonStep>;

/// "objects[0].loops[1][2]".
std::string to_text(const JsonPath& path);

/// Reads a file as JSON. Errors are one line, "path:line: error: <where>: ...", with `where` made by
/// `describe` from the place in the tree; NaN and Infinity, numbers beyond a double's range and keys that
/// appear twice are among them.
Result<nlohmann::json> read_json(const std::filesystem::path& path, std::string (*describe)(const JsonPath&));

}  // namespace gnomon::slb
