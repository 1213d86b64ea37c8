// SPDX-License-Identifier: Apache-2.0
// Values of metrics.json as the page writes them.
#include "host/report/page_text.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/report/numbers.hpp"

namespace gnomon::report {

std::string count(const Json& value) {
  return with_commas(value.get<std::uint64_t>());
}
std::string share(const Json& value) {
  return value.is_null() ? kNone : percent(value.get<double>());
}
std::string number(const Json& value, int digits) {
  return value.is_null() ? kNone : fixed(value.get<double>(), digits);
}
std::string seconds(const Json& value) {
  return value.is_null() ? kNone : duration(value.get<double>());
}
std::string plain(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Json row(std::string name, std::string value) {
  return {{"name", std::move(name)}, {"value", std::move(value)}};
}

std::string wall_text(const Json& metrics, std::string_view stage) {
  for (const Json& s : metrics["stages"]) {
    if (s["name"] == stage) return seconds(s["wall_seconds"]);
  }
  return kNone;
}

std::string configuration_line(const Json& m) {
  const Json& h = m["hardware"];
  return fmt::format(
      "{} · {}³ voxels, {}-adjacent · plane {}², {} voxels an entry · VOXEL_FRAC_BITS {} · NORMAL_BITS {} · "
      "MATRIX_FRAC_BITS {} · DEPTH_BITS {}",
      m["technique"].get<std::string>(), m["grid"]["res"].dump(), m["grid"]["adjacency"].dump(),
      m["plane"]["side"].dump(), fmt::format("{:g}", m["plane"]["pitch"].get<double>()),
      h["VOXEL_FRAC_BITS"].dump(), h["NORMAL_BITS"].dump(), h["MATRIX_FRAC_BITS"].dump(),
      h["DEPTH_BITS"].dump());
}

}  // namespace gnomon::report
