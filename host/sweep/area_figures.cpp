// SPDX-License-Identifier: Apache-2.0
// Figures of an area.
#include "host/sweep/area_figures.hpp"

namespace gnomon::sweep {

std::map<std::string, double> area_figures(const area::Area& area, std::optional<double> cycles) {
  const auto count = [](std::uint64_t cells) { return static_cast<double>(cells); };
  std::map<std::string, double> figures{{"area.luts", count(area.sum.luts)},
                                        {"area.carries", count(area.sum.carries)},
                                        {"area.flip_flops", count(area.sum.flip_flops)},
                                        {"area.dsps", count(area.sum.dsps)},
                                        {"area.rams", count(area.sum.rams)}};
  // The clock of some units alone would flatter what does not fit.
  if (!area.all_placed()) return figures;
  const double mhz = *area.clock_mhz();
  figures["area.clock_mhz"] = mhz;
  figures["area.period_ns"] = 1e3 / mhz;
  if (cycles) figures["area.seconds"] = *cycles / (1e6 * mhz);
  return figures;
}

}  // namespace gnomon::sweep
