// SPDX-License-Identifier: Apache-2.0
// The results file: what it keeps, what it refuses, what survives.
#include "host/sweep/store.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <limits>

#include "tests/host/scene/files.hpp"

namespace gnomon::sweep {
namespace {

using testing::HasSubstr;

const SweepRecord kSweep{"widths", "axes = 1", "1", "2026-01-01T00:00:00Z"};

Row row(const std::string& key, double share = 0.25) {
  return {key,
          "a.obj",
          R"({"technique":"slb"})",
          "a.obj --set technique=slb",
          "",
          "2026-01-01T00:00:00Z",
          {{"errors.fixed.all.share", share}, {"seconds.golden", 0.5}},
          {{"verdict", "2 words compared, 0 differ"}}};
}

Row failed(const std::string& key) {
  Row row{key, "a.obj", "{}", "a.obj", "depth_bits=9 makes no legal hardware", "2026-01-01T00:00:00Z",
          {},  {}};
  return row;
}

class StoreFile : public testing::Test {
 protected:
  std::filesystem::path file(const char* name = "results.sqlite") const { return folder_.path() / name; }
  Store open(const char* name = "results.sqlite") const {
    return std::move(*Store::open(file(name), kSweep));
  }
  test::TempDir folder_;
};

TEST_F(StoreFile, GivesBackWhatWasPut) {
  {
    Store store = open();
    store.put(row("k1"));
    store.put(failed("k2"));
  }
  const Store store = open();
  EXPECT_EQ(store.keys(), (std::map<std::string, bool>{{"k1", false}, {"k2", true}}));
  const std::vector<Row> rows = store.rows();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].figures, row("k1").figures);
  EXPECT_EQ(rows[0].labels, row("k1").labels);
  EXPECT_EQ(rows[0].flags, row("k1").flags);
  EXPECT_EQ(rows[0].configuration, row("k1").configuration);
  EXPECT_TRUE(rows[1].failed());
  EXPECT_EQ(rows[1].error, failed("k2").error);
  EXPECT_EQ(store.sweep().specification, kSweep.specification);
}

TEST_F(StoreFile, APointIsReplacedNotRepeated) {
  Store store = open();
  store.put(failed("k"));
  store.put(row("k", 0.5));
  const std::vector<Row> rows = store.rows();
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].failed());
  EXPECT_EQ(rows[0].figures.at("errors.fixed.all.share"), 0.5);
}

TEST_F(StoreFile, WhatIsNoNumberIsLeftOut) {
  Store store = open();
  Row some = row("k");
  some.figures["gain"] = std::numeric_limits<double>::infinity();
  store.put(some);
  EXPECT_FALSE(store.rows()[0].figures.contains("gain"));
}

TEST_F(StoreFile, AnotherSpecificationNeedsToBeToldSo) {
  open().put(row("k"));
  SweepRecord other = kSweep;
  other.specification = "axes = 2";
  const auto refused = Store::open(file(), other);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("--extend"));
  const auto extended = Store::open(file(), other, true);
  ASSERT_TRUE(extended);
  EXPECT_EQ(extended->keys().size(), 1U);
}

TEST_F(StoreFile, OtherFilesAreRefusedAndLeftAlone) {
  folder_.write("text.sqlite",
                "this is a text of more than a hundred bytes, so that it cannot be taken for a file that was "
                "just begun, or an empty one");
  EXPECT_FALSE(Store::open(file("text.sqlite"), kSweep));
  sqlite3* other = nullptr;
  ASSERT_EQ(sqlite3_open(file("other.sqlite").c_str(), &other), SQLITE_OK);
  sqlite3_exec(other, "CREATE TABLE t (x)", nullptr, nullptr, nullptr);
  sqlite3_close(other);
  const auto refused = Store::open(file("other.sqlite"), kSweep);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("is no results file"));
  EXPECT_FALSE(Store::open_existing(file("none.sqlite")));
  EXPECT_FALSE(std::filesystem::exists(file("none.sqlite")));
}

TEST_F(StoreFile, TheViewHasARowAPoint) {
  open().put(row("k"));
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file().c_str(), &database), SQLITE_OK);
  std::string seen;
  const auto note = [](void* to, int, char** values, char**) {
    *static_cast<std::string*>(to) += std::string(values[0]) + " " + values[1] + ";";
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, "SELECT technique, mislabelled FROM results", note, &seen, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  EXPECT_EQ(seen, "slb 0.25;");
}

/// A process that is killed while it writes loses nothing that it had put.
TEST_F(StoreFile, SurvivesKill) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Store store = std::move(*Store::open(file(), kSweep));
    for (int i = 0;; ++i) {
      store.put(row("k" + std::to_string(i)));
      if (i == 20 && write(pipe_ends[1], "x", 1) != 1) _exit(1);
    }
  }
  char seen = 0;
  ASSERT_EQ(read(pipe_ends[0], &seen, 1), 1);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const Store store = open();
  const std::vector<Row> rows = store.rows();
  EXPECT_GE(rows.size(), 21U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].key, "k" + std::to_string(i));
    EXPECT_EQ(rows[i].figures.size(), 2U);
  }
}

TEST_F(StoreFile, MergesEachKeyOnce) {
  Store all = open();
  all.put(row("k1"));
  all.put(failed("k2"));
  Store shard = open("shard.sqlite");
  Row slower = row("k1");
  slower.figures["seconds.golden"] = 9;
  shard.put(slower);
  shard.put(row("k2"));
  shard.put(row("k3"));
  const auto counts = all.merge(shard);
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->added, 1U);
  EXPECT_EQ(counts->replaced, 1U);
  EXPECT_EQ(counts->known, 1U);
  EXPECT_EQ(all.keys(), (std::map<std::string, bool>{{"k1", false}, {"k2", false}, {"k3", false}}));
  const auto again = all.merge(shard);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->added + again->replaced, 0U);
}

TEST_F(StoreFile, WhatWasAddedLaterIsNoDisagreement) {
  Store all = open();
  all.put(row("k1"));
  all.amend("k1", {{"rtl.cycles", 5}, {"confirm.words", 2}, {"area.luts", 7}}, {{"confirmed", "agrees"}});
  Store shard = open("shard.sqlite");
  shard.put(row("k1"));
  const auto counts = all.merge(shard);
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->known, 1U);
  EXPECT_EQ(all.rows()[0].figures.at("area.luts"), 7);
}

TEST_F(StoreFile, AnAmendmentTakesThePlaceOfAnEarlierOne) {
  Store store = open();
  store.put(row("k1"));
  store.put(row("k2"));
  for (const char* key : {"k1", "k2"})
    store.amend(key, {{"area.luts", 7}, {"area.clock_mhz", 40}, {"arealess", 1}},
                {{"area.none", "too wide"}});
  store.amend("k1", {{"area.luts", 8}}, {}, "area.");
  const std::vector<Row> rows = store.rows();
  std::map<std::string, double> expected = row("k1").figures;
  expected.merge(std::map<std::string, double>{{"area.luts", 8}, {"arealess", 1}});
  EXPECT_EQ(rows[0].figures, expected);
  EXPECT_EQ(rows[0].labels, row("k1").labels);
  EXPECT_EQ(rows[1].figures.at("area.clock_mhz"), 40);
}

TEST_F(StoreFile, ResultsThatDisagreeAreNotMerged) {
  Store all = open();
  all.put(row("k1"));
  Store shard = open("shard.sqlite");
  shard.put(row("k0"));
  shard.put(row("k1", 0.26));
  const auto refused = all.merge(shard);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("errors.fixed.all.share"));
  EXPECT_EQ(all.keys().size(), 1U);
}

}  // namespace
}  // namespace gnomon::sweep
