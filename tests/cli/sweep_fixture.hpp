// SPDX-License-Identifier: Apache-2.0
// A folder with a cube and a sweep of it.
#pragma once

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/sweep/figures.hpp"
#include "host/sweep/store.hpp"
#include "tests/cli/run_gnomon.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::test {

inline constexpr const char* kSweepSpec = R"(
scenes = ["cube.obj"]
[fixed]
res = 32
plane = 32
[axes]
technique = ["slb", "voxel-offset"]
frac_bits = [3, 5, 7]
)";

class SweepTest : public testing::Test {
 protected:
  SweepTest() {
    directory_.write("cube.obj", cube_text());
    spec_ = directory_.write("spec.toml", kSweepSpec);
  }
  Outcome sweep(const std::string& output, const std::vector<std::string>& more = {},
                const HowToRun& how = {}) const {
    std::vector<std::string> arguments{"sweep", spec_.string(), "-o", (directory_.path() / output).string(),
                                       "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gnomon(arguments, how);
  }
  nlohmann::json figures(const std::string& output, std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const Outcome outcome = sweep(output, more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }
  /// Everything but wall times, in an order of its own.
  std::string table(const std::string& output) const {
    sqlite3* database = nullptr;
    EXPECT_EQ(sqlite3_open((directory_.path() / output / "results.sqlite").c_str(), &database), SQLITE_OK);
    std::string text;
    const auto add = [](void* to, int count, char** values, char**) {
      for (int i = 0; i < count; ++i)
        *static_cast<std::string*>(to) += std::string(values[i] ? values[i] : "") + "|";
      *static_cast<std::string*>(to) += "\n";
      return 0;
    };
    const char* query =
        "SELECT key, configuration, status, error, name, value FROM point LEFT JOIN figure ON point.id = "
        "figure.point "
        "WHERE name IS NULL OR (name NOT LIKE 'seconds.%' AND name NOT LIKE 'host.%') ORDER BY key, name";
    EXPECT_EQ(sqlite3_exec(database, query, add, &text, nullptr), SQLITE_OK);
    sqlite3_close(database);
    return text;
  }
  /// Of the point with these settings, "key=value" each.
  std::map<std::string, double> figures_of(const std::string& output,
                                           const std::vector<std::string>& settings) const {
    const auto store = sweep::Store::open_existing(directory_.path() / output / "results.sqlite");
    EXPECT_TRUE(store);
    for (const sweep::Row& row : store->rows()) {
      const bool same = std::ranges::all_of(settings, [&](const std::string& setting) {
        const std::size_t equals = setting.find('=');
        return sweep::parameter_text(row, setting.substr(0, equals)) == setting.substr(equals + 1);
      });
      if (same) return row.figures;
    }
    return {};
  }
  /// How many points a file holds so far; 0 if it is not there yet.
  static int rows_of(const std::filesystem::path& file) {
    sqlite3* database = nullptr;
    int count = 0;
    if (sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) {
      const auto take = [](void* to, int, char** values, char**) {
        *static_cast<int*>(to) = std::stoi(values[0]);
        return 0;
      };
      sqlite3_exec(database, "SELECT count(*) FROM point", take, &count, nullptr);
    }
    sqlite3_close(database);
    return count;
  }
  TempDir directory_;
  std::filesystem::path spec_;
};

}  // namespace gnomon::test
