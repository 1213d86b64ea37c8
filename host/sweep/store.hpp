// SPDX-License-Identifier: Apache-2.0
// The results of a sweep in one SQLite file. Schema and rules: docs/sweep.md, "Results".
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"

struct sqlite3;

namespace gnomon::sweep {

/// What a sweep's file says about itself.
struct SweepRecord {
  std::string name, specification, model_version, started;
};

/// One measured point.
struct Row {
  std::string key;
  std::string scene;
  std::string configuration;  ///< JSON: every parameter
  std::string flags;          ///< what reproduces it after "gnomon run"
  std::string error;          ///< empty: done
  std::string finished;       ///< UTC, ISO 8601
  std::map<std::string, double> figures;
  std::map<std::string, std::string> labels;

  bool failed() const { return !error.empty(); }
};

/// What a merge found.
struct MergeCounts {
  std::size_t added = 0, known = 0, replaced = 0;  ///< replaced: a failed point by a done one
};

class Store {
 public:
  /// Opens or makes the file. Fails where it cannot be written, is no such file, or holds another
  /// specification's results and `extend` is false.
  static Result<Store> open(const std::filesystem::path& path, const SweepRecord& sweep, bool extend = false);

  /// Fails where the file is not there or is none of ours.
  static Result<Store> open_existing(const std::filesystem::path& path);

  /// Key to whether it failed, of all points.
  std::map<std::string, bool> keys() const;
  /// One transaction; replaces a point of the same key. Figures that are not finite are left out.
  void put(const Row& row);
  /// Adds to a point that is there, or replaces what it has of these names, and of all names that start with
  /// `instead_of` if that is not empty. One transaction.
  void amend(const std::string& key, const std::map<std::string, double>& figures,
             const std::map<std::string, std::string>& labels, const std::string& instead_of = {});
  /// By id: the order in which they were put.
  std::vector<Row> rows() const;
  SweepRecord sweep() const;

  /// Takes over another file's points. Fails, and changes nothing, where both hold a done point whose figures
  /// differ in more than wall time (figures named "seconds.*" and "host.*") and what was added later
  /// ("rtl.*", "confirm.*", "area.*").
  Result<MergeCounts> merge(const Store& other);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  explicit Store(std::unique_ptr<sqlite3, Close> database) : database_(std::move(database)) {}
  static Result<Store> connect(const std::filesystem::path& path, int flags);
  bool is_ours() const;
  void create(const SweepRecord& sweep);
  void insert(const Row& row);
  void insert_figures(std::int64_t id, const std::map<std::string, double>& figures,
                      const std::map<std::string, std::string>& labels);

  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace gnomon::sweep
