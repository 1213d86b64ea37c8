// SPDX-License-Identifier: Apache-2.0
// Wires walker, store, winding and query together, and counts.
#include <algorithm>
#include <gnomon/golden/slb/model.hpp>
#include <stdexcept>
#include <string>

namespace gnomon::golden::slb {

std::array<std::pair<const char*, std::uint64_t>, 23> named(const SlbCounters& counters) {
  const SlbCounters& c = counters;
  return {{{"SLB_OBJECTS", c.objects},
           {"SLB_LOOPS", c.loops},
           {"SLB_LOOPS_SHORT", c.loops_short},
           {"SLB_LOOPS_TINY", c.loops_tiny},
           {"SLB_TINY_AREA2", c.tiny_area2},
           {"SLB_VERTICES", c.vertices},
           {"SLB_VERTICES_REPEATED", c.vertices_repeated},
           {"SLB_CROSSINGS", c.crossings},
           {"SLB_CHAINS", c.chains},
           {"SLB_CHAINS_OFF_PLANE", c.chains_off_plane},
           {"SLB_CHAINS_DROPPED", c.chains_dropped},
           {"SLB_CHAINS_REDUCED", c.chains_reduced},
           {"SLB_GROUPS_EVICTED", c.groups_evicted},
           {"SLB_WINDING_SATURATED", c.winding_saturated},
           {"SLB_FILL_PIXELS", c.fill_pixels},
           {"SLB_FILL_GROUPS", c.fill_groups},
           {"SLB_FILL_COVERED", c.fill_covered},
           {"SLB_COVERS", c.covers},
           {"SLB_COVERS_USED", c.covers_used},
           {"SLB_QUERIES", c.queries},
           {"SLB_QUERIES_SHADOW", c.queries_shadow},
           {"SLB_QUERIES_OFF_PLANE", c.queries_off_plane},
           {"SLB_QUERIES_OVERFLOW", c.queries_overflow}}};
}

SlbModel::SlbModel(const SlbConfig& config)
    : config_([&] {
        if (const auto error = config.check()) throw std::invalid_argument(*error);
        return config;
      }()),
      store_(config_),
      winding_(config_),
      builder_(
          config_, [this](const Chain& chain) { put(chain); },
          [this](std::int64_t column, std::int64_t row, bool upwards) { cross_row(column, row, upwards); }) {}

void SlbModel::reset() {
  store_.reset();
  winding_.reset();
  if (state_ == State::Loop) builder_.forget();
  state_ = State::Idle;
  has_loops_ = false;
  counters_ = SlbCounters{};
  sticky_ = SlbSticky{};
}

void SlbModel::require(bool condition, const char* what) const {
  if (!condition) throw std::logic_error(std::string("out of order: ") + what);
}

bool SlbModel::on_plane(std::int64_t column, std::int64_t row) const {
  return column >= 0 && column < config_.side() && row >= 0 && row < config_.side();
}

void SlbModel::clear() {
  require(state_ == State::Idle, "clear inside an object");
  store_.clear();
}

void SlbModel::begin_object(std::uint8_t object, bool flat, std::uint32_t depth) {
  require(state_ == State::Idle, "an object inside an object");
  state_ = State::Object;
  has_loops_ = false;
  object_ = object;
  flat_ = flat;
  depth_ = depth;
  winding_.begin();
  ++counters_.objects;
}

void SlbModel::enter_loop() {
  require(state_ == State::Object || state_ == State::Loop, "a loop outside an object's loops");
  state_ = State::Loop;
  has_loops_ = true;
}

void SlbModel::vertex(const Vertex& vertex) {
  enter_loop();
  ++counters_.vertices;
  const std::uint64_t repeated = builder_.repeated(), crossings = builder_.crossings();
  builder_.vertex(flat_ ? Vertex{vertex.x, vertex.y, depth_} : vertex);
  counters_.vertices_repeated += builder_.repeated() - repeated;
  counters_.crossings += builder_.crossings() - crossings;
}

void SlbModel::close_loop() {
  enter_loop();
  state_ = State::Object;
  const std::uint64_t repeated = builder_.repeated(), crossings = builder_.crossings();
  const LoopSummary summary = builder_.close();
  ++counters_.loops;
  counters_.loops_short += summary.too_short ? 1 : 0;
  counters_.loops_tiny += summary.tiny ? 1 : 0;
  counters_.tiny_area2 += summary.tiny_area2;
  counters_.vertices_repeated += summary.repeated - repeated;
  counters_.crossings += summary.crossings - crossings;
}

void SlbModel::loop(std::span<const Vertex> vertices) {
  for (const Vertex& v : vertices) vertex(v);
  close_loop();
}

void SlbModel::put(Chain chain) {
  if (!on_plane(chain.column, chain.row)) {
    ++counters_.chains_off_plane;
    return;
  }
  ++counters_.chains;
  const bool before = winding_.mark_lines(static_cast<int>(chain.column), static_cast<int>(chain.row));
  const FragmentStore::Insertion done = store_.insert(chain, object_, !before);
  counters_.chains_dropped += done.dropped ? 1 : 0;
  counters_.chains_reduced += done.reduced ? 1 : 0;
  counters_.groups_evicted += done.evicted ? 1 : 0;
  sticky_.line_overflow = sticky_.line_overflow || done.dropped || done.reduced;
  sticky_.object_overflow = sticky_.object_overflow || done.evicted;
}

void SlbModel::cross_row(std::int64_t column, std::int64_t row, bool upwards) {
  if (winding_.crossing(column, row, upwards)) return;
  ++counters_.winding_saturated;
  sticky_.winding_saturated = true;
}

void SlbModel::fill() {
  require(state_ == State::Object, "a fill outside an object or after its fill");
  state_ = State::Filled;
  if (sweep_) *sweep_ = {winding_.first_row(), winding_.last_row(), {}};
  for (int row = winding_.first_row(); row <= winding_.last_row(); ++row) {
    const std::span<const Winding::Pixel> swept = winding_.take_row(row);
    if (sweep_) note_row(swept);
    for (int column = 0; column < config_.side(); ++column) {
      const auto i = static_cast<std::size_t>(column);
      ++counters_.fill_pixels;
      const Winding::Pixel& pixel = swept[i];
      Winding::Result result{pixel.winding >= 1, false};
      if (pixel.lines) {
        ++counters_.fill_groups;
        const FragmentStore::Finish done = store_.finish(column, row, pixel.winding, !flat_);
        result = {done.covered, done.rim};
      }
      winding_.set_result(column, row, result);
      if (!result.covered) continue;
      ++counters_.fill_covered;
      if (flat_) store_.lower_full_depth(column, row, depth_);
    }
  }
}

void SlbModel::note_row(std::span<const Winding::Pixel> row) {
  const std::size_t pixels = std::min<std::size_t>(kLinePixels, row.size());
  for (std::size_t first = 0; first < row.size(); first += pixels) {
    const auto line = row.subspan(first, pixels);
    unsigned with_lines = 0;
    for (std::size_t i = 0; i < line.size(); ++i) with_lines |= line[i].lines ? 1U << i : 0U;
    sweep_->lines.push_back({static_cast<std::uint16_t>(with_lines), line.back().winding >= 1});
  }
}

void SlbModel::cover(const CoverSample& sample, std::uint32_t margin) {
  require(state_ == State::Filled, "a cover sample before the object's fill");
  ++counters_.covers;
  if (!on_plane(sample.column, sample.row)) return;
  const int column = static_cast<int>(sample.column), row = static_cast<int>(sample.row);
  const Winding::Result pixel = winding_.result(column, row);
  if (!pixel.covered) return;
  const std::uint64_t reach = (std::uint64_t{1} << sample.range) - 1;
  const auto front = static_cast<std::uint32_t>(sample.depth - std::min<std::uint64_t>(reach, sample.depth));
  if (pixel.rim && !store_.is_full(column, row, front, sample.depth, margin)) return;
  ++counters_.covers_used;
  store_.lower_full_depth(column, row, sample.depth);
}

void SlbModel::end_object() {
  require(state_ == State::Filled || (state_ == State::Object && !has_loops_),
          "the end of an object without its fill");
  state_ = State::Idle;
}

QueryAnswer SlbModel::query(const QueryPoint& point, std::uint32_t bias) {
  require(state_ == State::Idle, "a query inside an object");
  ++counters_.queries;
  const int q = config_.query_bits;
  const std::int64_t column = point.x >> q, row = point.y >> q;
  QueryAnswer result;
  if (!on_plane(column, row)) {
    ++counters_.queries_off_plane;
    result.off_plane = true;
    return result;
  }
  const std::int64_t mask = (std::int64_t{1} << q) - 1;
  const PixelPoint inside{2 * (point.x & mask) + 1, 2 * (point.y & mask) + 1, q + 1};
  result = answer(store_.read(static_cast<int>(column), static_cast<int>(row)), inside, point.depth, bias,
                  config_);
  counters_.queries_shadow += result.shadow ? 1 : 0;
  counters_.queries_overflow += result.overflow ? 1 : 0;
  return result;
}

}  // namespace gnomon::golden::slb
