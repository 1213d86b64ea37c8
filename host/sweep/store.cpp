// SPDX-License-Identifier: Apache-2.0
// The results file.
#include "host/sweep/store.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/sweep/statement.hpp"

namespace gnomon::sweep {
namespace {

constexpr const char* kSchema = R"(
CREATE TABLE sweep (schema INTEGER NOT NULL, name TEXT NOT NULL, specification TEXT NOT NULL,
                    model_version TEXT NOT NULL, started TEXT NOT NULL);
CREATE TABLE point (id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, scene TEXT NOT NULL,
                    configuration TEXT NOT NULL, flags TEXT NOT NULL,
                    status TEXT NOT NULL CHECK (status IN ('done', 'failed')),
                    error TEXT NOT NULL, finished TEXT NOT NULL);
CREATE TABLE figure (point INTEGER NOT NULL REFERENCES point(id) ON DELETE CASCADE, name TEXT NOT NULL,
                     value REAL, PRIMARY KEY (point, name)) WITHOUT ROWID;
CREATE TABLE label (point INTEGER NOT NULL REFERENCES point(id) ON DELETE CASCADE, name TEXT NOT NULL,
                    text TEXT NOT NULL, PRIMARY KEY (point, name)) WITHOUT ROWID;
CREATE VIEW results AS
  SELECT point.id, point.scene, json_extract(configuration, '$.technique') AS technique,
         max(CASE figure.name WHEN 'errors.fixed.boundary_displacement' THEN figure.value END) AS displacement,
         max(CASE figure.name WHEN 'errors.fixed.all.share' THEN figure.value END) AS mislabelled,
         max(CASE figure.name WHEN 'model.cycles' THEN figure.value END) AS cycles,
         max(CASE figure.name WHEN 'memory.hardware_bits' THEN figure.value END) AS memory_bits,
         point.configuration
  FROM point LEFT JOIN figure ON figure.point = point.id WHERE point.status = 'done' GROUP BY point.id;
)";
constexpr sqlite3_int64 kSchemaNumber = 1;
/// Marks the file as ours ("Gnom").
constexpr sqlite3_int64 kApplication = 0x476e6f6d;
constexpr int kBusyMilliseconds = 60000;

/// Wall times, which no two measurements share; and what a confirmation or an estimate of the area has added
/// to a point that was measured.
bool is_compared(const std::string& figure) {
  for (const char* prefix : {"seconds.", "host.", "rtl.", "confirm.", "area."}) {
    if (figure.starts_with(prefix)) return false;
  }
  return true;
}

/// The first figure that is compared and that only one has or that differs; empty if there is none.
std::string difference(const Row& a, const Row& b) {
  for (const auto& [name, value] : a.figures) {
    const auto other = b.figures.find(name);
    if (is_compared(name) && (other == b.figures.end() || other->second != value)) return name;
  }
  for (const auto& [name, value] : b.figures) {
    if (is_compared(name) && !a.figures.contains(name)) return name;
  }
  return {};
}

}  // namespace

void Store::Close::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

Result<Store> Store::connect(const std::filesystem::path& path, int flags) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &opened, flags, nullptr);
  std::unique_ptr<sqlite3, Close> database(opened);
  if (code != SQLITE_OK)
    return fail(fmt::format("{}: error: cannot be opened: {}", path.string(), sqlite3_errstr(code)));
  sqlite3_busy_timeout(opened, kBusyMilliseconds);
  // Whole after a crash of the program at any moment, and after one of the machine but for the last points.
  execute(opened, "PRAGMA synchronous = NORMAL");
  return Store(std::move(database));
}

bool Store::is_ours() const {
  Statement application(database_.get(), "PRAGMA application_id");
  return application.step() && application.integer(0) == kApplication;
}

void Store::create(const SweepRecord& sweep) {
  sqlite3* database = database_.get();
  execute(database, "PRAGMA journal_mode = WAL");
  Transaction transaction(database);
  execute(database, kSchema);
  execute(database, fmt::format("PRAGMA application_id = {}", kApplication).c_str());
  Statement(database, "INSERT INTO sweep VALUES (?, ?, ?, ?, ?)")
      .bind(1, kSchemaNumber)
      .bind(2, sweep.name)
      .bind(3, sweep.specification)
      .bind(4, sweep.model_version)
      .bind(5, sweep.started)
      .step();
  transaction.commit();
}

Result<Store> Store::open(const std::filesystem::path& path, const SweepRecord& sweep, bool extend) try {
  auto store = connect(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (!store) return store;
  execute(store->database_.get(), "PRAGMA foreign_keys = ON");
  Statement tables(store->database_.get(), "SELECT count(*) FROM sqlite_master");
  tables.step();
  if (tables.integer(0) == 0) {
    tables.reset();
    store->create(sweep);
    return store;
  }
  if (!store->is_ours()) return fail(path.string() + ": error: is no results file of a sweep");
  if (!extend && store->sweep().specification != sweep.specification)
    return fail(path.string() +
                ": error: holds the results of another specification; --extend adds to them, -o names "
                "another directory");
  return store;
} catch (const std::runtime_error& problem) {
  return fail(fmt::format("{}: error: {}", path.string(), problem.what()));
}

Result<Store> Store::open_existing(const std::filesystem::path& path) try {
  auto store = connect(path, SQLITE_OPEN_READWRITE);
  if (!store) return store;
  if (!store->is_ours()) return fail(path.string() + ": error: is no results file of a sweep");
  execute(store->database_.get(), "PRAGMA foreign_keys = ON");
  return store;
} catch (const std::runtime_error& problem) {
  return fail(fmt::format("{}: error: {}", path.string(), problem.what()));
}

SweepRecord Store::sweep() const {
  Statement query(database_.get(), "SELECT name, specification, model_version, started FROM sweep");
  query.step();
  return {query.text(0), query.text(1), query.text(2), query.text(3)};
}

std::map<std::string, bool> Store::keys() const {
  Statement query(database_.get(), "SELECT key, status FROM point");
  std::map<std::string, bool> keys;
  while (query.step()) keys.emplace(query.text(0), query.text(1) == "failed");
  return keys;
}

void Store::insert(const Row& row) {
  sqlite3* database = database_.get();
  Statement(database, "DELETE FROM point WHERE key = ?").bind(1, row.key).step();
  Statement(database,
            "INSERT INTO point (key, scene, configuration, flags, status, error, finished) VALUES (?, ?, ?, "
            "?, ?, ?, ?)")
      .bind(1, row.key)
      .bind(2, row.scene)
      .bind(3, row.configuration)
      .bind(4, row.flags)
      .bind(5, std::string(row.failed() ? "failed" : "done"))
      .bind(6, row.error)
      .bind(7, row.finished)
      .step();
  insert_figures(sqlite3_last_insert_rowid(database), row.figures, row.labels);
}

void Store::insert_figures(std::int64_t id, const std::map<std::string, double>& figures,
                           const std::map<std::string, std::string>& labels) {
  Statement figure(database_.get(), "INSERT OR REPLACE INTO figure VALUES (?, ?, ?)");
  for (const auto& [name, value] : figures) {
    if (!std::isfinite(value)) continue;  // SQLite has no such number
    figure.bind(1, sqlite3_int64{id}).bind(2, name).bind(3, value).step();
    figure.reset();
  }
  Statement label(database_.get(), "INSERT OR REPLACE INTO label VALUES (?, ?, ?)");
  for (const auto& [name, text] : labels) {
    label.bind(1, sqlite3_int64{id}).bind(2, name).bind(3, text).step();
    label.reset();
  }
}

void Store::amend(const std::string& key, const std::map<std::string, double>& figures,
                  const std::map<std::string, std::string>& labels, const std::string& instead_of) {
  Transaction transaction(database_.get());
  Statement point(database_.get(), "SELECT id FROM point WHERE key = ?");
  if (!point.bind(1, key).step()) throw std::logic_error("a point that is not there is amended");
  const sqlite3_int64 id = point.integer(0);
  if (!instead_of.empty()) {
    for (const char* table : {"figure", "label"}) {
      Statement(database_.get(),
                fmt::format("DELETE FROM {} WHERE point = ? AND substr(name, 1, ?) = ?", table).c_str())
          .bind(1, id)
          .bind(2, static_cast<sqlite3_int64>(instead_of.size()))
          .bind(3, instead_of)
          .step();
    }
  }
  insert_figures(id, figures, labels);
  transaction.commit();
}

void Store::put(const Row& row) {
  Transaction transaction(database_.get());
  insert(row);
  transaction.commit();
}

std::vector<Row> Store::rows() const {
  sqlite3* database = database_.get();
  Statement points(database,
                   "SELECT id, key, scene, configuration, flags, error, finished FROM point ORDER BY id");
  std::vector<Row> rows;
  std::map<sqlite3_int64, std::size_t> place;
  while (points.step()) {
    place.emplace(points.integer(0), rows.size());
    rows.push_back({points.text(1),
                    points.text(2),
                    points.text(3),
                    points.text(4),
                    points.text(5),
                    points.text(6),
                    {},
                    {}});
  }
  Statement figures(database, "SELECT point, name, value FROM figure");
  while (figures.step())
    rows[place.at(figures.integer(0))].figures.emplace(figures.text(1), figures.number(2));
  Statement labels(database, "SELECT point, name, text FROM label");
  while (labels.step()) rows[place.at(labels.integer(0))].labels.emplace(labels.text(1), labels.text(2));
  return rows;
}

Result<MergeCounts> Store::merge(const Store& other) {
  std::map<std::string, Row> known;
  for (Row& row : rows()) known.emplace(row.key, std::move(row));
  MergeCounts counts;
  Transaction transaction(database_.get());
  for (const Row& row : other.rows()) {
    const auto mine = known.find(row.key);
    if (mine == known.end()) {
      insert(row);
      ++counts.added;
    } else if (mine->second.failed() && !row.failed()) {
      insert(row);
      ++counts.replaced;
    } else {
      ++counts.known;
      const std::string differs = row.failed() || mine->second.failed() ? "" : difference(mine->second, row);
      if (!differs.empty())
        return fail(
            fmt::format("two results of the same point differ in {}: {} {}", differs, row.scene, row.flags));
    }
  }
  transaction.commit();
  return counts;
}

}  // namespace gnomon::sweep
