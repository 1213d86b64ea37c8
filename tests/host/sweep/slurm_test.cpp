// SPDX-License-Identifier: Apache-2.0
// What is handed to Slurm, with a stand-in for sbatch; tests/slurm runs the real one.
#include "host/sweep/slurm.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace gnomon::sweep {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SlurmTest : public testing::Test {
 protected:
  SlurmTest() : path_(std::getenv("PATH")) {
    std::string name = (fs::temp_directory_path() / "gnomon-slurm-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
    sweep_ = {"/opt/gnomon", "/data/my sweep.toml", root_ / "out",     8,    2,
              {"--retry"},   {"--plots"},           {"--partition=p"}, false};
  }
  ~SlurmTest() override {
    setenv("PATH", path_.c_str(), 1);
    fs::remove_all(root_);
  }
  SlurmTest(const SlurmTest&) = delete;
  SlurmTest& operator=(const SlurmTest&) = delete;

  /// Only what is in this folder can be started from now on.
  void stand_in(const std::string& does) {
    const fs::path folder = root_ / "bin";
    fs::create_directories(folder);
    std::ofstream(folder / "sbatch") << "#!/bin/sh\n" << does << '\n';
    fs::permissions(folder / "sbatch", fs::perms::owner_all);
    setenv("PATH", folder.c_str(), 1);
  }
  std::string content(const std::string& name) const {
    std::ifstream file(root_ / "out" / "slurm" / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::string path_;
  fs::path root_;
  SlurmSweep sweep_;
};

TEST_F(SlurmTest, ATaskMeasuresTheShardOfItsNumber) {
  const std::string text = shard_script(sweep_);
  EXPECT_THAT(text, testing::StartsWith("#!/bin/sh\n"));
  EXPECT_THAT(text, HasSubstr("exec /opt/gnomon sweep '/data/my sweep.toml' -o " + (root_ / "out").string() +
                              " -q -j 2 --retry --shard \"$SLURM_ARRAY_TASK_ID/8\"\n"));
  EXPECT_THAT(merge_script(sweep_), HasSubstr("-q --merge --plots\n"));
}

TEST_F(SlurmTest, TheMergeWaitsForAllShards) {
  stand_in("echo \"$@\" >> ../../asked; echo 17; exit 0");
  const auto jobs = submit(sweep_);
  ASSERT_TRUE(jobs) << jobs.error().message;
  EXPECT_EQ(jobs->array, "17");
  std::ifstream file(root_ / "asked");
  std::string array, merge;
  ASSERT_TRUE(std::getline(file, array) && std::getline(file, merge));
  for (const char* word : {"--partition=p", "--array=1-8", "--cpus-per-task=2", "--requeue", "shard.sh"})
    EXPECT_THAT(array, HasSubstr(word));
  for (const char* word : {"--partition=p", "--dependency=afterany:17", "merge.sh"})
    EXPECT_THAT(merge, HasSubstr(word));
  EXPECT_THAT(merge, testing::Not(HasSubstr("--wait")));
  EXPECT_EQ(content("shard.sh"), shard_script(sweep_));
}

TEST_F(SlurmTest, SaysWhatSbatchSays) {
  stand_in("echo 'sbatch: error: invalid partition specified: p'; exit 1");
  const auto refused = submit(sweep_);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("invalid partition"));
  fs::remove(root_ / "bin" / "sbatch");
  const auto absent = submit(sweep_);
  ASSERT_FALSE(absent);
  EXPECT_THAT(absent.error().message, HasSubstr("sbatch is not there"));
}

}  // namespace
}  // namespace gnomon::sweep
