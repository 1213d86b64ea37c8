// SPDX-License-Identifier: Apache-2.0
// The cache: nothing is built twice, nothing wrong is ever found in it, and a build that fails says why.
#include "sim/model_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <thread>
#include <vector>

#include "sim/content_hash.hpp"
#include "tests/sim/tiny_model.hpp"

namespace gnomon::sim::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ModelCacheTest : public testing::Test {
 protected:
  /// A cache with the runtime of the shared one, so that only models are compiled here.
  ModelCacheTest() {
    ModelCache(tiny_tools()).load({});
    for (const fs::directory_entry& entry : fs::directory_iterator(tiny_tools().cache_dir)) {
      if (entry.path().filename().string().starts_with("runtime-") && entry.path().extension().empty()) {
        fs::copy(entry.path(), folder_.path() / entry.path().filename());
      }
    }
  }

  Toolchain tools() const { return tiny_tools(folder_.path()); }
  int models() const {
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
      count += entry.path().filename().string().starts_with("model-");
    }
    return count;
  }

  TemporaryFolder folder_;
};

TEST_F(ModelCacheTest, BuildsOnceAndFindsAgain) {
  ModelCache first(tools());
  first.load({});
  EXPECT_EQ(first.built(), 1);
  first.load({});
  EXPECT_EQ(first.built(), 1);
  ModelCache second(tools());
  EXPECT_NE(second.load({}), nullptr);
  EXPECT_EQ(second.built(), 0);
}

TEST_F(ModelCacheTest, PrebuiltModelsAreUsedAndNotCopied) {
  ModelCache(tools()).load({});
  const TemporaryFolder empty;
  Toolchain other = tiny_tools(empty.path());
  other.prebuilt_dir = folder_.path();
  ModelCache cache(other);
  cache.load({});
  EXPECT_EQ(cache.built(), 0);
}

TEST_F(ModelCacheTest, EverythingThatMattersIsPartOfTheKey) {
  const TemporaryFolder rtl;
  fs::copy(TINY_RTL_DIR, rtl.path(), fs::copy_options::recursive);
  Toolchain copied = tools();
  copied.rtl_dir = rtl.path();
  const ModelCache cache(copied);
  std::vector<fs::path> entries{cache.entry({}),
                                cache.entry({.config = {.depth_bits = 19}}),
                                cache.entry({.trace = true}),
                                cache.entry({.coverage = true}),
                                cache.entry({.assertions = true}),
                                cache.entry({.plain_bit_operations = true}),
                                cache.entry({.quick_build = true}),
                                cache.entry({.defines = {"TINY_HANGS"}})};
  std::ofstream(rtl.path() / "gnomon_core.sv", std::ios::app) << "// changed\n";
  entries.push_back(cache.entry({}));
  std::ofstream(rtl.path() / "included.svh") << "\n";
  entries.push_back(cache.entry({}));
  std::sort(entries.begin(), entries.end());
  EXPECT_EQ(std::adjacent_find(entries.begin(), entries.end()), entries.end());
  fs::remove(rtl.path() / "included.svh");
  EXPECT_TRUE(std::binary_search(entries.begin(), entries.end(), cache.entry({})));
}

TEST_F(ModelCacheTest, ConcurrentThreadsBuildOneModel) {
  std::atomic<int> built{0};
  std::array<std::thread, 4> threads;
  for (std::thread& thread : threads) {
    thread = std::thread([&] {
      ModelCache cache(tools());
      cache.load({});
      built += cache.built();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(built, 1);
  EXPECT_EQ(models(), 1);
}

TEST_F(ModelCacheTest, ConcurrentProcessesBuildOneModel) {
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ModelCache cache(tools());
      cache.load({});
      _exit(cache.built());
    }
    children.push_back(child);
  }
  int built = 0;
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    built += WEXITSTATUS(status);
  }
  EXPECT_EQ(built, 1);
  EXPECT_EQ(models(), 1);
}

TEST_F(ModelCacheTest, DamagedEntriesAreMadeAgain) {
  ModelCache cache(tools());
  cache.load({});
  const fs::path entry = cache.entry({});
  const auto size = fs::file_size(entry / "model.so");

  fs::resize_file(entry / "model.so", size / 2);
  cache.load({});
  EXPECT_EQ(cache.built(), 2);
  EXPECT_EQ(fs::file_size(entry / "model.so"), size);

  fs::remove(entry / "manifest.txt");
  cache.load({});
  EXPECT_EQ(cache.built(), 3);

  fs::remove(entry / "model.so");
  cache.load({});
  EXPECT_EQ(cache.built(), 4);
}

TEST_F(ModelCacheTest, WhatADeadBuilderLeftIsNotInTheWay) {
  ModelCache cache(tools());
  const fs::path left = cache.entry({}).string() + ".building";
  fs::create_directories(left / "model.so");  // not even a file
  cache.load({});
  EXPECT_EQ(cache.built(), 1);
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(ModelCacheTest, RefusedParametersAreNamedAndLeaveNothing) {
  ModelCache cache(tools());
  const ModelSpec spec{.config = {.plane_log2 = 13}};
  try {
    cache.load(spec);
    FAIL() << "PLANE_LOG2=13 was accepted";
  } catch (const ModelBuildError& error) {
    EXPECT_THAT(error.what(), HasSubstr("PLANE_LOG2=13 is out of range 4..12"));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  EXPECT_EQ(models(), 0);
  ASSERT_TRUE(cache.refusal(spec).has_value());
  EXPECT_THAT(*cache.refusal(spec), HasSubstr("PLANE_LOG2=13 is out of range 4..12"));
  EXPECT_EQ(cache.refusal({}), std::nullopt);
}

TEST_F(ModelCacheTest, RtlThatDoesNotCompileIsNamed) {
  const TemporaryFolder rtl;
  write_file(rtl.path() / "gnomon.f", "gnomon_core.sv\n");
  write_file(rtl.path() / "gnomon_core.sv", "module gnomon_core(input logic clk_i)\nendmodule\n");
  Toolchain broken = tools();
  broken.rtl_dir = rtl.path();
  ModelCache cache(broken);
  try {
    cache.load({});
    FAIL() << "a syntax error was accepted";
  } catch (const ModelBuildError& error) {
    EXPECT_THAT(error.what(), HasSubstr("gnomon_core.sv:2"));
  }
}

TEST_F(ModelCacheTest, MissingPiecesAreNamed) {
  Toolchain no_rtl = tools();
  no_rtl.rtl_dir = folder_.path() / "nowhere";
  ModelCache without_rtl(no_rtl);
  EXPECT_THROW(without_rtl.load({}), ModelBuildError);

  Toolchain no_verilator = tools();
  no_verilator.verilator = "/nowhere/verilator";
  EXPECT_THROW(ModelCache{no_verilator}, std::runtime_error);
}

TEST_F(ModelCacheTest, AnotherFileIsNoModel) {
  const fs::path file = folder_.path() / "model.so";
  write_file(file, "not a shared object");
  EXPECT_THROW(ModelLibrary{file}, std::runtime_error);
}

}  // namespace
}  // namespace gnomon::sim::test
