// SPDX-License-Identifier: Apache-2.0
// Single entries of a scene file, checked. Every error is one line, "path:line: error: ...", naming the key.
#pragma once

#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/config/document.hpp"

namespace gnomon::scene {

using Pointer = config::Document::Pointer;

/// An entry's key for messages: "models/0/translate".
std::string key_of(const Pointer& entry);

bool has(const config::Document& document, const Pointer& table, const char* key);

/// Refuses the entry at `at` where `is` does not hold; `kind` says what was expected: "a table".
Result<void> expect(const config::Document& document, const Pointer& at,
                    bool (nlohmann::json::*is)() const noexcept, std::string_view kind);

/// A finite number.
Result<double> read_number(const config::Document& document, const Pointer& at);
/// A text that is not empty.
Result<std::string> read_text(const config::Document& document, const Pointer& at);
/// true or false.
Result<bool> read_flag(const config::Document& document, const Pointer& at);
/// Three finite numbers.
Result<Vec3> read_vector(const config::Document& document, const Pointer& at);

}  // namespace gnomon::scene
