// SPDX-License-Identifier: Apache-2.0
// SQLite statements and transactions that close themselves.
#pragma once

#include <sqlite3.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gnomon::sweep {

/// Throws std::runtime_error with SQLite's reason: after opening, a statement fails only by our or the disk's
/// fault.
inline void check(sqlite3* database, int code) {
  if (code != SQLITE_OK && code != SQLITE_DONE && code != SQLITE_ROW)
    throw std::runtime_error(std::string("results file: ") + sqlite3_errmsg(database));
}

inline void execute(sqlite3* database, const char* sql) {
  check(database, sqlite3_exec(database, sql, nullptr, nullptr, nullptr));
}

class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql) : database_(database) {
    sqlite3_stmt* statement = nullptr;
    check(database,
          sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr));
    statement_.reset(statement);
  }

  /// Parameters count from 1, columns from 0, as in SQLite.
  Statement& bind(int at, const std::string& text) {
    check(database_,
          sqlite3_bind_text(statement_.get(), at, text.data(), static_cast<int>(text.size()),
                            SQLITE_TRANSIENT));  // NOLINT(performance-no-int-to-ptr): SQLite's macro
    return *this;
  }
  Statement& bind(int at, double value) {
    check(database_, sqlite3_bind_double(statement_.get(), at, value));
    return *this;
  }
  Statement& bind(int at, sqlite3_int64 value) {
    check(database_, sqlite3_bind_int64(statement_.get(), at, value));
    return *this;
  }
  /// True while there is a row.
  bool step() {
    const int code = sqlite3_step(statement_.get());
    check(database_, code);
    return code == SQLITE_ROW;
  }
  /// To be used again with other values.
  void reset() { check(database_, sqlite3_reset(statement_.get())); }

  std::string text(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_.get(), column);
    return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
  }
  double number(int column) const { return sqlite3_column_double(statement_.get(), column); }
  sqlite3_int64 integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Undone unless committed.
class Transaction {
 public:
  explicit Transaction(sqlite3* database) : database_(database) { execute(database, "BEGIN IMMEDIATE"); }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction() {
    if (!done_) sqlite3_exec(database_, "ROLLBACK", nullptr, nullptr, nullptr);
  }
  void commit() {
    execute(database_, "COMMIT");
    done_ = true;
  }

 private:
  sqlite3* database_;
  bool done_ = false;
};

}  // namespace gnomon::sweep
