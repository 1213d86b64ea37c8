// SPDX-License-Identifier: Apache-2.0
// What this program was built with.
#include "host/cli/versions.hpp"

#include <embree3/rtcore_config.h>
#include <fmt/format.h>
#include <opensubdiv/version.h>
#include <openvdb/version.h>
#include <spdlog/version.h>
#include <tbb/version.h>
#include <toml++/toml.h>

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

namespace gnomon::cli {

std::vector<std::pair<std::string, std::string>> versions() {
  return {{"gnomon", GNOMON_VERSION},
          {"Verilator", GNOMON_BUILT_WITH_VERILATOR},
          {"OpenSubdiv", fmt::format("{}.{}.{}", OPENSUBDIV_VERSION_NUMBER / 10000,
                                     OPENSUBDIV_VERSION_NUMBER / 100 % 100, OPENSUBDIV_VERSION_NUMBER % 100)},
          {"Embree", RTC_VERSION_STRING},
          {"OpenVDB", OPENVDB_LIBRARY_VERSION_STRING},
          {"oneTBB", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
          {"CLI11", CLI11_VERSION},
          {"toml++", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
          {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                        NLOHMANN_JSON_VERSION_PATCH)},
          {"spdlog", fmt::format("{}.{}.{}", SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH)},
          {"compiler", GNOMON_BUILT_WITH_COMPILER}};
}

std::string versions_text() {
  std::string text;
  for (const auto& [tool, version] : versions()) text += fmt::format("{} {}\n", tool, version);
  text.pop_back();
  return text;
}

}  // namespace gnomon::cli
