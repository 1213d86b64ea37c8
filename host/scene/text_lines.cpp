// SPDX-License-Identifier: Apache-2.0
// Logical lines of a text file.
#include "host/scene/text_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace gnomon::scene {
namespace {

/// More than any face or name needs; stops a huge file without line ends from filling memory.
constexpr std::size_t kLongestLine = std::size_t{256} << 20U;

bool starts_with_word(std::string_view line, std::string_view word) {
  return line.starts_with(word) &&
         (line.size() == word.size() || line[word.size()] == ' ' || line[word.size()] == '\t');
}

bool may_continue(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  return !line.starts_with('#') && !starts_with_word(line, "o") && !starts_with_word(line, "usemtl") &&
         !starts_with_word(line, "mtllib");
}

}  // namespace

Result<TextLines> TextLines::open(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return fail(path.string() + ": error: is a directory, expected a file");
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return fail(path.string() + ": error: cannot be read: " + std::strerror(errno));
  TextLines lines(file);
  lines.refill();
  if (lines.end_ >= 3 && std::memcmp(lines.buffer_.data(), "\xEF\xBB\xBF", 3) == 0) lines.at_ = 3;
  return lines;
}

bool TextLines::refill() {
  at_ = 0;
  end_ = std::fread(buffer_.data(), 1, buffer_.size(), file_.get());
  if (end_ == 0 && std::ferror(file_.get()) != 0)
    read_error_ = std::string("cannot be read: ") + std::strerror(errno);
  return end_ > 0;
}

bool TextLines::append_physical_line() {
  bool any = false;
  while (at_ < end_ || refill()) {
    if (after_cr_ && buffer_[at_] == '\n') ++at_;
    after_cr_ = false;
    const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(at_);
    const auto to = buffer_.begin() + static_cast<std::ptrdiff_t>(end_);
    const auto stop = std::find_if(from, to, [](char c) { return c == '\n' || c == '\r'; });
    any = any || from != to;
    line_.append(from, stop);
    at_ = static_cast<std::size_t>(stop - buffer_.begin());
    if (stop != to) {
      after_cr_ = *stop == '\r';
      ++at_;
      break;
    }
    if (line_.size() > kLongestLine) {
      read_error_ = "has a line of more than 256 MiB, expected an OBJ text";
      return false;
    }
  }
  if (any) ++physical_;
  return any;
}

bool TextLines::next() {
  line_.clear();
  if (!read_error_.empty() || !append_physical_line()) return false;
  number_ = physical_;
  while (read_error_.empty()) {
    const std::size_t last = line_.find_last_not_of(" \t");
    if (last == std::string::npos || line_[last] != '\\' || !may_continue(line_)) break;
    line_.resize(last);
    line_ += ' ';
    if (!append_physical_line()) break;
  }
  return read_error_.empty();
}

}  // namespace gnomon::scene
