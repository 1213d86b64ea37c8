// SPDX-License-Identifier: Apache-2.0
// Logical lines of a text file, with their line numbers, in one pass and little memory.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::scene {

/// Reads LF, CRLF and CR endings, a last line without one, a UTF-8 byte order mark, and lines continued with
/// a backslash (joined by a blank; a comment and the free text of o, usemtl and mtllib are never continued,
/// because Windows paths end in backslashes).
class TextLines {
 public:
  /// Fails for a missing file, a directory, one without read permission: one line naming the path.
  static Result<TextLines> open(const std::filesystem::path& path);

  /// Goes to the next logical line; false at the end of the file or after a read error.
  bool next();
  /// The current line without its ending. Valid until the next call of next().
  std::string_view text() const { return line_; }
  /// Number of the current logical line's first physical line, from 1.
  std::size_t number() const { return number_; }
  /// Why reading stopped early; empty if it did not.
  const std::string& read_error() const { return read_error_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  explicit TextLines(std::FILE* file) : file_(file), buffer_(1U << 20U) {}
  bool refill();
  bool append_physical_line();

  std::unique_ptr<std::FILE, Close> file_;
  std::vector<char> buffer_;
  std::size_t at_ = 0, end_ = 0;
  bool after_cr_ = false;
  std::string line_;
  std::size_t number_ = 0, physical_ = 0;
  std::string read_error_;
};

}  // namespace gnomon::scene
