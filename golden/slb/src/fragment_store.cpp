// SPDX-License-Identifier: Apache-2.0
// Putting chains into entries, and what happens when they do not fit.
#include <algorithm>
#include <gnomon/golden/slb/fragment_store.hpp>
#include <gnomon/golden/slb/query.hpp>

namespace gnomon::golden::slb {
namespace {

constexpr PixelPoint kCentre{1, 1, 1};

/// The first fragment of the open group with room for a second chain; null if none.
Fragment* half_used(Entry& entry) {
  for (int i = entry.last_group(); i < entry.count; ++i) {
    Fragment& fragment = entry.fragments[static_cast<std::size_t>(i)];
    if (fragment.op == FragmentOp::One) return &fragment;
  }
  return nullptr;
}

/// Takes fragments first..last-1 out.
void remove(Entry& entry, int first, int last) {
  std::move(entry.fragments.begin() + last, entry.fragments.begin() + entry.count,
            entry.fragments.begin() + first);
  const int count = entry.count - (last - first);
  std::fill(entry.fragments.begin() + count, entry.fragments.begin() + entry.count, Fragment{});
  entry.count = static_cast<std::uint8_t>(count);
}

}  // namespace

FragmentStore::FragmentStore(const SlbConfig& config) : config_(config) {
  reset();
}

void FragmentStore::reset() {
  rows_.clear();
  rows_.resize(static_cast<std::size_t>(config_.side()));
  generation_ = 1;
}

void FragmentStore::clear() {
  generation_ = generation_ == 255 ? 1 : static_cast<std::uint8_t>(generation_ + 1);
  const std::size_t side = rows_.size(), entries = side * side;
  const std::size_t share = (entries + 254) / 255;
  const std::size_t from = std::min((generation_ - std::size_t{1}) * share, entries);
  const std::size_t to = std::min(from + share, entries);
  for (std::size_t i = from; i < to; ++i) {
    Row& row = rows_[i / side];
    if (!row.heads.empty()) row.heads[i % side].generation = 0;
  }
}

Entry FragmentStore::load(int column, int row) const {
  const Row& stored = rows_[static_cast<std::size_t>(row)];
  const auto at = static_cast<std::size_t>(column);
  Entry entry;
  if (stored.heads.empty() || stored.heads[at].generation != generation_) {
    entry.full_depth = config_.no_depth();
    return entry;
  }
  const Head& head = stored.heads[at];
  entry.generation = head.generation;
  entry.count = head.count;
  entry.overflow = head.overflow;
  entry.open = head.open;
  entry.corner = head.corner;
  entry.full_depth = head.full_depth;
  const auto first = stored.fragments.begin() + std::ptrdiff_t{column} * config_.frags;
  std::copy_n(first, head.count, entry.fragments.begin());
  return entry;
}

FragmentStore::Row& FragmentStore::allocated(int row) {
  Row& stored = rows_[static_cast<std::size_t>(row)];
  if (stored.heads.empty()) {
    stored.heads.resize(rows_.size());
    stored.fragments.resize(rows_.size() * static_cast<std::size_t>(config_.frags));
  }
  return stored;
}

void FragmentStore::save(int column, int row, const Entry& entry) {
  Row& stored = allocated(row);
  stored.heads[static_cast<std::size_t>(column)] = {generation_, entry.count,  entry.overflow,
                                                    entry.open,  entry.corner, entry.full_depth};
  const auto first = stored.fragments.begin() + std::ptrdiff_t{column} * config_.frags;
  std::copy_n(entry.fragments.begin(), entry.count, first);
}

Entry FragmentStore::read(int column, int row) const {
  Entry entry = load(column, row);
  entry.generation = 0;
  return entry;
}

bool FragmentStore::make_room(Entry& entry, std::uint32_t depth, bool& evicted) const {
  // The farthest group goes; of equally far ones the later.
  int victim = -1, victim_end = 0;
  std::uint32_t farthest = depth;
  for (int first = 0; first < entry.count;) {
    int last = first + 1;
    std::uint32_t group_depth = entry.fragments[static_cast<std::size_t>(first)].depth;
    while (last < entry.count && entry.fragments[static_cast<std::size_t>(last)].cont)
      group_depth = std::max(group_depth, entry.fragments[static_cast<std::size_t>(last++)].depth);
    if (group_depth > depth && group_depth >= farthest) {
      victim = first;
      victim_end = last;
      farthest = group_depth;
    }
    first = last;
  }
  if (victim < 0) return false;
  int contained = 0;
  for (int i = victim; i < victim_end; ++i)
    contained += chains_containing(entry.fragments[static_cast<std::size_t>(i)], kCentre, config_);
  if (contained > entry.fragments[static_cast<std::size_t>(victim)].threshold_m1)
    entry.full_depth = std::min(entry.full_depth, farthest);
  remove(entry, victim, victim_end);
  entry.overflow = true;
  evicted = true;
  return true;
}

FragmentStore::Insertion FragmentStore::insert(const Chain& chain, std::uint8_t object, bool first) {
  const auto column = static_cast<int>(chain.column), row = static_cast<int>(chain.row);
  Entry entry = load(column, row);
  Insertion result;
  if (first) entry.corner = 0;
  Line single = chain.a;
  const bool room =
      entry.count < config_.frags || (!entry.open && make_room(entry, chain.depth, result.evicted));
  Fragment* free_slot = entry.open ? half_used(entry) : nullptr;
  if (chain.op != FragmentOp::One && !room && free_slot != nullptr) {
    // Of a corner that does not fit, keep the line that agrees with it at the pixel's centre.
    const bool centre = chain_contains(chain.op, chain.a, chain.b, kCentre, config_);
    if (inside(chain.a, kCentre, config_) != centre) single = chain.b;
    entry.overflow = result.reduced = true;
  }
  if (free_slot != nullptr && (chain.op == FragmentOp::One || result.reduced)) {
    free_slot->op = FragmentOp::Two;
    free_slot->b = single;
    free_slot->depth = std::max(free_slot->depth, chain.depth);
  } else if (room) {
    entry.fragments[entry.count++] = {chain.depth, object, chain.op, chain.a, chain.b, 0, entry.open};
    entry.open = true;
  } else {
    result.dropped = entry.overflow = true;
  }
  int change = chain.holds_corner ? 1 : 0;
  // A chain that is not kept counts by its answer at the pixel's centre.
  if (result.dropped && chain_contains(chain.op, chain.a, chain.b, kCentre, config_)) --change;
  entry.corner = static_cast<std::int8_t>(std::clamp(entry.corner + change, kCornerMin, kCornerMax));
  save(column, row, entry);
  return result;
}

FragmentStore::Finish FragmentStore::finish(int column, int row, int winding, bool keep_lines) {
  Entry entry = load(column, row);
  const int group = entry.open ? entry.last_group() : entry.count;
  const int chains = entry.chains(group, entry.count);
  const int threshold = 1 - winding + entry.corner;
  Finish result;
  result.covered = threshold <= 0;
  if (threshold > chains || (result.covered && !keep_lines)) {
    remove(entry, group, entry.count);
  } else if (group < entry.count) {
    entry.fragments[static_cast<std::size_t>(group)].threshold_m1 =
        static_cast<std::uint8_t>(std::max(threshold, 1) - 1);
    result.rim = true;
  }
  entry.open = false;
  entry.corner = 0;
  save(column, row, entry);
  return result;
}

bool FragmentStore::is_full(int column, int row, std::uint32_t front, std::uint32_t depth,
                            std::uint32_t margin) const {
  const Entry entry = load(column, row);
  if (entry.full_depth == config_.no_depth()) return true;
  for (int i = entry.last_group(); i < entry.count; ++i) {
    const std::uint64_t rim = entry.fragments[static_cast<std::size_t>(i)].depth;
    if (front <= rim + margin && rim <= std::uint64_t{depth} + margin) return false;
  }
  return true;
}

void FragmentStore::lower_full_depth(int column, int row, std::uint32_t depth) {
  Head& head = allocated(row).heads[static_cast<std::size_t>(column)];
  if (head.generation != generation_) head = {.generation = generation_, .full_depth = config_.no_depth()};
  head.full_depth = std::min(head.full_depth, depth);
}

}  // namespace gnomon::golden::slb
