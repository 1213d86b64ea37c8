// SPDX-License-Identifier: Apache-2.0
// Prints the mean border displacement of the silhouette-line buffer for every shape, F, S and K (docs/slb.md,
// "Measured").
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include "tests/golden/slb/displacement.hpp"

namespace {

using namespace gnomon::golden::slb;
using namespace gnomon::golden::slb::testing;

struct Options {
  int frac_first = 4, frac_last = 7, extra_slope = 0, instances = 4, per_pixel = 4000;
  bool published = false;
  std::string only;
};

int number(const char* text) {
  int value = 0;
  std::from_chars(text, text + std::strlen(text), value);
  return value;
}

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--published") {
      options.published = true;
      continue;
    }
    if (i + 1 == argc) return false;
    const char* value = argv[++i];
    if (key == "--frac-first")
      options.frac_first = number(value);
    else if (key == "--frac-last")
      options.frac_last = number(value);
    else if (key == "--extra-slope")
      options.extra_slope = number(value);
    else if (key == "--instances")
      options.instances = number(value);
    else if (key == "--per-pixel")
      options.per_pixel = number(value);
    else if (key == "--shape")
      options.only = value;
    else
      return false;
  }
  return options.instances > 0 && options.per_pixel > 0;
}

SlbConfig configuration(int frac, const Options& options, int frags) {
  SlbConfig config;
  config.frac_bits = frac;
  config.slope_bits = frac + options.extra_slope;
  config.frags = frags;
  config.plane_log2 = 6;
  config.depth_bits = 16;
  config.subpixel_bits = 12;
  config.query_bits = 16;
  config.rounding = options.published ? Rounding::Published : Rounding::Better;
  return config;
}

void row(const Shape& shape, int frac, const Options& options) {
  std::printf("%-22s F=%d S=%d", shape.name.c_str(), frac, frac + options.extra_slope);
  for (const int frags : {1, 2, 4}) {
    const SlbConfig config = configuration(frac, options, frags);
    Displacement sum;
    for (int i = 0; i < options.instances; ++i)
      sum += measure(shape.make(config, static_cast<std::uint64_t>(i) + 1), config, options.per_pixel,
                     static_cast<std::uint64_t>(i) + 1000);
    std::printf(" | K=%d %6.3f (%.6f px, dropped %llu of %llu)", frags, sum.ratio(), sum.mean(),
                static_cast<unsigned long long>(sum.dropped), static_cast<unsigned long long>(sum.chains));
    if (frags == 4)
      std::printf(" | map %.4f px, 2^F finer %.6f px", sum.wrong_area_plain / sum.length,
                  sum.wrong_area_fine / sum.length);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(
        stderr,
        "usage: slb_displacement [--frac-first F] [--frac-last F] [--extra-slope S-F] [--instances N]\n"
        "                        [--per-pixel N] [--shape NAME] [--published]\n");
    return 2;
  }
  for (const Shape& s : shapes())
    for (int frac = options.frac_first; frac <= options.frac_last; ++frac)
      if (options.only.empty() || options.only == s.name) row(s, frac, options);
  return 0;
}
