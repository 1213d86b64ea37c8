// SPDX-License-Identifier: Apache-2.0
// Points that are to be confirmed.
#include "host/sweep/selection.hpp"

#include <fmt/format.h>

#include <charconv>

#include "host/sweep/confirm.hpp"
#include "host/sweep/figures.hpp"

namespace gnomon::sweep {

Result<Selection> Selection::parse(const std::string& text) {
  Selection selection;
  if (text.empty()) return selection;
  if (text == "front" || text == "all") {
    selection.kind_ = text == "all" ? Kind::All : Kind::Front;
    return selection;
  }
  selection.kind_ = Kind::Some;
  const char* end = text.data() + text.size();
  const auto [last, problem] = std::from_chars(text.data(), end, selection.count_);
  if (problem != std::errc() || last != end || selection.count_ == 0)
    return fail(fmt::format("--confirm {}: expected front, all, or how many", text));
  return selection;
}

std::set<std::string> Selection::choose(const std::vector<Row>& rows) const {
  const std::vector<bool> front = on_front(rows);
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].failed() && (kind_ != Kind::Front || front[i])) candidates.push_back(i);
  }
  const std::size_t wanted = kind_ == Kind::None   ? 0
                             : kind_ == Kind::Some ? std::min(count_, candidates.size())
                                                   : candidates.size();
  std::set<std::string> keys;
  for (std::size_t k = 0; k < wanted; ++k) {
    const Row& row = rows[candidates[k * candidates.size() / wanted]];
    const auto label = row.labels.find(std::string(kConfirmLabel));
    if (label == row.labels.end() || label->second != kAgrees) keys.insert(row.key);
  }
  return keys;
}

}  // namespace gnomon::sweep
