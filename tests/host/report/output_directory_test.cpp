// SPDX-License-Identifier: Apache-2.0
// Results appear all at once or not at all, and nobody else's files are lost.
#include "host/report/output_directory.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>

namespace gnomon::report {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class OutputDirectoryTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "gnomon-output-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::set<std::string> names(const fs::path& directory) {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(directory)) all.insert(entry.path().filename().string());
    return all;
  }
  static std::string content(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

  static void write_and_commit(const fs::path& target, const std::string& text) {
    auto output = OutputDirectory::create(target);
    ASSERT_TRUE(output) << output.error().message;
    ASSERT_TRUE(output->write("report.html", text));
    ASSERT_TRUE(output->write("metrics.json", text));
    const auto done = output->commit("metrics.json");
    ASSERT_TRUE(done) << done.error().message;
  }

  fs::path root_;
};

TEST_F(OutputDirectoryTest, AppearsAtCommitWithItsParents) {
  auto output = OutputDirectory::create(root_ / "a" / "b" / "out");
  ASSERT_TRUE(output);
  ASSERT_TRUE(output->write("metrics.json", "new"));
  EXPECT_FALSE(fs::exists(root_ / "a"));
  ASSERT_TRUE(output->commit("metrics.json"));
  EXPECT_EQ(content(root_ / "a" / "b" / "out" / "metrics.json"), "new");
  EXPECT_THAT(names(root_), ElementsAre("a"));
}

TEST_F(OutputDirectoryTest, ABareNameIsInTheWorkingDirectory) {
  const fs::path before = fs::current_path();
  fs::current_path(root_);
  write_and_commit("out", "new");
  write_and_commit("some/parents/out", "new");
  fs::current_path(before);
  EXPECT_EQ(content(root_ / "out" / "report.html"), "new");
  EXPECT_EQ(content(root_ / "some" / "parents" / "out" / "report.html"), "new");
}

TEST_F(OutputDirectoryTest, LeavesNothingWithoutCommit) {
  { ASSERT_TRUE(OutputDirectory::create(root_ / "out")->write("metrics.json", "new")); }
  EXPECT_THAT(names(root_), IsEmpty());
}

TEST_F(OutputDirectoryTest, WithoutCommitTheOldResultsStay) {
  fs::create_directory(root_ / "out");
  put(root_ / "out" / "metrics.json", "old");
  { ASSERT_TRUE(OutputDirectory::create(root_ / "out")->write("metrics.json", "new")); }
  EXPECT_EQ(content(root_ / "out" / "metrics.json"), "old");
  EXPECT_THAT(names(root_), ElementsAre("out"));
}

TEST_F(OutputDirectoryTest, ReplacesResultsAndKeepsTheRest) {
  fs::create_directories(root_ / "out" / "mine");
  put(root_ / "out" / "mine" / "deep.txt", "deep");
  put(root_ / "out" / "notes.txt", "notes");
  put(root_ / "out" / "report.html", "old");
  write_and_commit(root_ / "out", "new");
  EXPECT_EQ(content(root_ / "out" / "report.html"), "new");
  EXPECT_EQ(content(root_ / "out" / "notes.txt"), "notes");
  EXPECT_EQ(content(root_ / "out" / "mine" / "deep.txt"), "deep");
  EXPECT_THAT(names(root_ / "out"), ElementsAre("metrics.json", "mine", "notes.txt", "report.html"));
  EXPECT_THAT(names(root_), ElementsAre("out"));
}

TEST_F(OutputDirectoryTest, ADirectoryThatSomebodyWorksInStaysThatDirectory) {
  fs::create_directory(root_ / "out");
  put(root_ / "out" / "report.html", "old");
  const fs::path before = fs::current_path();
  fs::current_path(root_ / "out");
  write_and_commit(".", "new");
  EXPECT_EQ(content("report.html"), "new");
  EXPECT_THAT(names("."), ElementsAre("metrics.json", "report.html"));
  fs::current_path(before);
  EXPECT_THAT(names(root_), ElementsAre("out"));
}

TEST_F(OutputDirectoryTest, ALinkToADirectoryStaysALink) {
  fs::create_directory(root_ / "real");
  fs::create_directory_symlink("real", root_ / "out");
  write_and_commit(root_ / "out", "new");
  EXPECT_TRUE(fs::is_symlink(root_ / "out"));
  EXPECT_EQ(content(root_ / "real" / "report.html"), "new");
}

TEST_F(OutputDirectoryTest, ATargetThatIsNoDirectoryIsRefused) {
  put(root_ / "out", "a file");
  for (const fs::path& target : {root_ / "out", root_ / "out" / "below"}) {
    const auto output = OutputDirectory::create(target);
    ASSERT_FALSE(output);
    EXPECT_THAT(output.error().message, HasSubstr("not a directory"));
    EXPECT_THAT(output.error().message, HasSubstr(target.string()));
  }
  EXPECT_EQ(content(root_ / "out"), "a file");
}

TEST_F(OutputDirectoryTest, ADirectoryThatCannotBeWrittenIsRefused) {
  const auto output = OutputDirectory::create("/proc/gnomon/out");
  ASSERT_FALSE(output);
  EXPECT_THAT(output.error().message, HasSubstr("/proc"));
}

}  // namespace
}  // namespace gnomon::report
