// SPDX-License-Identifier: Apache-2.0
// Main program of a model that cache_figures builds: runs the words of a file over memories of several
// latencies, compares every result, and prints a line for each: latency, cycles, results, wrong ones, lines
// read, lines written.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "Vgnomon_core.h"
#include "sim/counter_names.hpp"
#include "tests/rtl/cache/core_cache_bench.hpp"

namespace {

using gnomon::golden::Word;

constexpr std::size_t kClearPass = 2;

std::vector<Word> read_words(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<Word> words(bytes.size() / sizeof(Word));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
  return words;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return 2;
  const std::vector<Word> words = read_words(arguments[1]);
  const std::vector<Word> expected = read_words(arguments[2]);
  const auto cycles_per_line = static_cast<std::uint32_t>(std::stoul(arguments[3]));
  for (int i = 4; i < count; ++i) {
    const auto latency = static_cast<std::uint32_t>(std::stoul(arguments[i]));
    gnomon::rtl_test::CoreCacheBench<Vgnomon_core> bench(
        {.latency = latency, .spread = 0, .cycles_per_line = cycles_per_line, .open_per_256 = 256});
    const std::vector<Word> results = bench.run(words);
    std::size_t wrong = results.size() == expected.size() ? 0 : 1;
    for (std::size_t k = 0; k < results.size() && k < expected.size(); ++k)
      wrong += results[k] != expected[k];
    const auto& traffic = bench.memory().traffic();
    // On chip most of them are the scrubbing after the reset, which is no part of what a job costs.
    std::uint64_t cycles = bench.cycles();
    for (std::size_t cause = 0; cause < gnomon::sim::kCauseNames.size(); ++cause)
      cycles -= bench.counter(gnomon::sim::cycle_counter_index(kClearPass, cause));
    std::printf("%u %llu %zu %zu %llu %llu\n", latency, static_cast<unsigned long long>(cycles),
                results.size(), wrong, static_cast<unsigned long long>(traffic.reads),
                static_cast<unsigned long long>(traffic.writes));
    std::fflush(stdout);
  }
  return 0;
}
