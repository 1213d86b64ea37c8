// SPDX-License-Identifier: Apache-2.0
// A recursive-descent reader of sums.
#include "tests/golden/formula.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace gnomon::golden_test {
namespace {

class Reader {
 public:
  Reader(std::string text, const std::map<char, int>& symbols) : text_(std::move(text)), symbols_(symbols) {}

  int whole() {
    const int value = sum();
    if (at_ != text_.size()) fail();
    return value;
  }

 private:
  int sum() {
    int value = term();
    while (peek() == '+' || peek() == '-') {
      const int sign = text_[at_++] == '+' ? 1 : -1;
      value += sign * term();
    }
    return value;
  }

  int term() {
    if (take("max(")) {
      const int a = sum();
      expect(",");
      const int b = sum();
      expect(")");
      return std::max(a, b);
    }
    int factor = 1;
    const bool number = std::isdigit(static_cast<unsigned char>(peek())) != 0;
    if (number) {
      factor = 0;
      while (std::isdigit(static_cast<unsigned char>(peek())) != 0)
        factor = 10 * factor + (text_[at_++] - '0');
    }
    const auto symbol = symbols_.find(peek());
    if (symbol == symbols_.end()) return number ? factor : fail();
    ++at_;
    return factor * symbol->second;
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(std::string_view token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  void expect(std::string_view token) {
    if (!take(token)) fail();
  }
  [[noreturn]] int fail() const { throw std::invalid_argument("not a width formula: " + text_); }

  std::string text_;
  const std::map<char, int>& symbols_;
  std::size_t at_ = 0;
};

/// Without blanks, and with the typographic minus as ASCII.
std::string normalised(std::string_view formula) {
  static constexpr std::string_view kMinus = "\u2212";
  std::string text;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula.substr(i, kMinus.size()) == kMinus) {
      text += '-';
      i += kMinus.size() - 1;
    } else if (formula[i] != ' ') {
      text += formula[i];
    }
  }
  return text;
}

}  // namespace

int evaluate(std::string_view formula, const std::map<char, int>& symbols) {
  return Reader(normalised(formula), symbols).whole();
}

}  // namespace gnomon::golden_test
