// SPDX-License-Identifier: Apache-2.0
// The search and the recording are two runs of the same model, so that the second repeats the first cycle by
// cycle.
#include "sim/wave.hpp"

#include <algorithm>
#include <cctype>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/stream.hpp>

namespace gnomon::sim {

Wave write_window(const TracedEngine& make, RtlOptions options, std::span<const Word> stream,
                  const TraceWindow& window) {
  options.trace = window;
  if (window.to < UINT64_MAX) options.max_cycles = std::min(options.max_cycles, window.to + 1);
  const auto engine = make(options);
  try {
    engine->submit(stream);
    engine->drain([](std::span<const Word>) {});
  } catch (const CycleLimit&) {  // the window's end
  } catch (const HangError&) {   // what a window around a hang is for
  } catch (const RtlFault&) {
  }
  return {window, std::nullopt};
}

Wave write_window(const golden::HardwareConfig& config, RtlOptions options, std::span<const Word> stream,
                  const TraceWindow& window, ModelCache& cache) {
  const TracedEngine make = [&](const RtlOptions& traced) { return make_rtl_engine(config, traced, cache); };
  return write_window(make, std::move(options), stream, window);
}

std::optional<std::size_t> find_command(std::span<const Word> stream, std::string_view name) {
  const auto same = [](char a, char b) {
    return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
  };
  for (std::size_t at = 0; at < stream.size();
       at += std::size_t{1} + golden::decode_header(stream[at]).count) {
    const std::string text = golden::describe_header(stream[at]);
    const std::string_view found = std::string_view(text).substr(0, text.find(' '));
    if (std::ranges::equal(found, name, same)) return at;
  }
  return std::nullopt;
}

std::uint64_t cycle_of_header(const golden::HardwareConfig& config, RtlOptions options,
                              std::span<const Word> stream, std::size_t at, ModelCache& cache) {
  options.trace.reset();
  options.trace_model = true;
  const auto engine = make_rtl_engine(config, options, cache);
  engine->submit(stream.first(at + 1));
  return engine->cycle() - 1;
}

Wave write_first_difference(golden::Engine& reference, RtlOptions options, std::span<const Word> stream,
                            const std::filesystem::path& file, const Surroundings& surroundings,
                            ModelCache& cache) {
  options.trace.reset();
  options.trace_model = true;
  CompareOptions stop;
  stop.stop_at_first = true;
  const auto engine = make_rtl_engine(reference.config(), options, cache);
  CompareReport report = compare(reference, *engine, stream, stop, options.seed);
  if (report.consistent()) return {{}, std::move(report)};
  const std::uint64_t cycle = report.first && report.first->cycle ? *report.first->cycle : report.cycles;
  const TraceWindow window{cycle - std::min(cycle, surroundings.before), cycle + surroundings.after, file};
  Wave wave = write_window(reference.config(), options, stream, window, cache);
  wave.report = std::move(report);
  return wave;
}

}  // namespace gnomon::sim
