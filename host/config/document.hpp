// SPDX-License-Identifier: Apache-2.0
// A JSON or TOML file as one tree, with the lines of its entries where the format's parser tells them.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "host/base/result.hpp"

namespace gnomon::config {

/// Every message of this file's functions is one line, "path:line: error: ..." (JSON entries have no line).
class Document {
 public:
  using Pointer = nlohmann::json::json_pointer;

  /// By the extension: .toml or .json. The root is a table.
  static Result<Document> read(const std::filesystem::path& path);

  const nlohmann::json& root() const { return root_; }
  const std::filesystem::path& path() const { return path_; }
  /// "path:line" of an entry, or "path" where the line is not known.
  std::string place(const Pointer& entry) const;
  /// "place: error: message" about an entry.
  tl::unexpected<Error> refuse(const Pointer& entry, const std::string& message) const;
  /// Fails for the first key of the table at `table` that is not among `known`, naming the nearest one.
  Result<void> check_keys(const Pointer& table, std::initializer_list<std::string_view> known) const;

 private:
  nlohmann::json root_;
  std::map<std::string, std::size_t> lines_;
  std::filesystem::path path_;
};

}  // namespace gnomon::config
