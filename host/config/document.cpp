// SPDX-License-Identifier: Apache-2.0
// A JSON or TOML file as one tree.
#include "host/config/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "host/config/nearest.hpp"

namespace gnomon::config {
namespace {

Result<std::string> text_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return fail(path.string() + ": error: is a directory, expected a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file) return fail(fmt::format("{}: error: cannot be read: {}", path.string(), std::strerror(errno)));
  return text.str();
}

/// One line of a parser's message.
std::string one_line(std::string text) {
  for (char& c : text) c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return text;
}

/// Converts TOML to JSON and notes the line of every node under its JSON pointer.
class TomlToJson {
 public:
  explicit TomlToJson(std::map<std::string, std::size_t>& lines) : lines_(lines) {}

  nlohmann::json convert(const toml::node& node, const Document::Pointer& at) {
    lines_[at.to_string()] = node.source().begin.line;
    if (const toml::table* table = node.as_table()) {
      nlohmann::json object = nlohmann::json::object();
      for (const auto& [key, value] : *table) {
        const std::string name(key.str());
        object[name] = convert(value, at / name);
        // A table's own line is that of its first entry; its key's line is what the user looks for.
        if (key.source().begin.line > 0) lines_[(at / name).to_string()] = key.source().begin.line;
      }
      return object;
    }
    if (const toml::array* array = node.as_array()) {
      nlohmann::json list = nlohmann::json::array();
      for (const toml::node& value : *array) list.push_back(convert(value, at / list.size()));
      return list;
    }
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* integer = node.as_integer()) return integer->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* flag = node.as_boolean()) return flag->get();
    // Dates: kept as text, so that whoever reads the entry says what was expected.
    std::ostringstream text;
    text << toml::node_view<const toml::node>(node);
    return text.str();
  }

 private:
  std::map<std::string, std::size_t>& lines_;
};

}  // namespace

Result<Document> Document::read(const std::filesystem::path& path) {
  const Result<std::string> text = text_of(path);
  if (!text) return tl::make_unexpected(text.error());
  Document document;
  document.path_ = path;
  try {
    if (path.extension() == ".toml") {
      document.root_ = TomlToJson(document.lines_).convert(toml::parse(*text, path.string()), Pointer());
    } else {
      document.root_ = nlohmann::json::parse(*text);
    }
  } catch (const toml::parse_error& error) {
    return fail(fmt::format("{}:{}: error: {}", path.string(), error.source().begin.line,
                            one_line(std::string(error.description()))));
  } catch (const nlohmann::json::parse_error& error) {
    const auto line =
        1 + std::count(text->begin(),
                       text->begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text->size())), '\n');
    return fail(fmt::format("{}:{}: error: {}", path.string(), line, one_line(error.what())));
  }
  if (!document.root_.is_object()) return document.refuse(Pointer(), "expected a table of keys and values");
  return document;
}

std::string Document::place(const Pointer& entry) const {
  const auto line = lines_.find(entry.to_string());
  if (line == lines_.end() || line->second == 0) return path_.string();
  return fmt::format("{}:{}", path_.string(), line->second);
}

tl::unexpected<Error> Document::refuse(const Pointer& entry, const std::string& message) const {
  return fail(fmt::format("{}: error: {}", place(entry), message));
}

Result<void> Document::check_keys(const Pointer& table, std::initializer_list<std::string_view> known) const {
  const std::vector<std::string_view> names(known);
  for (const auto& [key, value] : root_.at(table).items()) {
    if (std::find(names.begin(), names.end(), key) != names.end()) continue;
    return refuse(table / key, fmt::format("unknown key '{}', {}", (table / key).to_string().substr(1),
                                           suggestion(key, names)));
  }
  return {};
}

}  // namespace gnomon::config
