// SPDX-License-Identifier: Apache-2.0
// Delta debugging over commands, then over the items of each.
#include "sim/shrink.hpp"

#include <algorithm>
#include <gnomon/golden/stream.hpp>
#include <stdexcept>
#include <utility>

#include "sim/compare.hpp"

namespace gnomon::sim {

namespace {

struct Piece {
  golden::Header header;
  std::vector<Word> items;
};

std::vector<Piece> split(std::span<const Word> stream) {
  std::vector<Piece> pieces;
  golden::CommandReader reader(stream);
  while (const auto command = reader.next()) {
    pieces.push_back({command->header, {command->items.begin(), command->items.end()}});
  }
  return pieces;
}

std::vector<Word> join(const std::vector<Piece>& pieces) {
  std::vector<Word> words;
  for (const Piece& piece : pieces) {
    golden::Header header = piece.header;
    header.count = static_cast<std::uint16_t>(piece.items.size());
    words.push_back(golden::encode(header));
    words.insert(words.end(), piece.items.begin(), piece.items.end());
  }
  return words;
}

/// `list` without the elements from first to first + count.
template <typename T>
std::vector<T> without(const std::vector<T>& list, std::size_t first, std::size_t count) {
  std::vector<T> rest(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first));
  rest.insert(rest.end(), list.begin() + static_cast<std::ptrdiff_t>(std::min(first + count, list.size())),
              list.end());
  return rest;
}

class Shrinker {
 public:
  Shrinker(const StillFails& still_fails, const ShrinkOptions& options)
      : still_fails_(still_fails), options_(options) {}

  bool fails(const std::vector<Piece>& pieces) {
    ++trials_;
    return still_fails_(join(pieces));
  }

  /// Leaves out what can be left out of `list`; `fails_with` judges a candidate. Whether anything went.
  template <typename T>
  bool minimize(std::vector<T>& list, const std::function<bool(const std::vector<T>&)>& fails_with) {
    const std::size_t before = list.size();
    for (std::size_t group = std::max<std::size_t>(list.size() / 2, 1); group > 0; group /= 2) {
      for (std::size_t first = 0; first < list.size() && trials_ < options_.max_trials;) {
        std::vector<T> candidate = without(list, first, group);
        if (fails_with(candidate)) {
          list = std::move(candidate);
        } else {
          first += group;
        }
      }
    }
    return list.size() < before;
  }

  void run(std::vector<Piece>& pieces) {
    bool smaller = true;
    while (smaller && trials_ < options_.max_trials) {
      smaller =
          minimize<Piece>(pieces, [&](const std::vector<Piece>& candidate) { return fails(candidate); });
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        smaller |= minimize<Word>(pieces[i].items, [&](const std::vector<Word>& items) {
          std::vector<Piece> candidate = pieces;
          candidate[i].items = items;
          return fails(candidate);
        });
      }
    }
  }

  int trials() const { return trials_; }

 private:
  const StillFails& still_fails_;
  ShrinkOptions options_;
  int trials_ = 0;
};

}  // namespace

Shrunk shrink(std::span<const Word> stream, const StillFails& still_fails, const ShrinkOptions& options) {
  if (!still_fails(stream)) throw std::invalid_argument("the stream to shrink does not fail");
  std::vector<Piece> pieces = split(stream);
  Shrinker shrinker(still_fails, options);
  shrinker.run(pieces);
  return {join(pieces), shrinker.trials()};
}

StillFails differs(std::function<std::unique_ptr<golden::Engine>()> reference,
                   std::function<std::unique_ptr<RtlEngine>()> rtl) {
  return [reference = std::move(reference), rtl = std::move(rtl)](std::span<const Word> stream) {
    const auto expected = reference();
    const auto actual = rtl();
    CompareOptions options;
    options.stop_at_first = true;
    return !compare(*expected, *actual, stream, options).consistent();
  };
}

}  // namespace gnomon::sim
