// SPDX-License-Identifier: Apache-2.0
// A cube over a ground, the directories that its runs write to, and a stand-in for the hardware.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/pipeline/run.hpp"
#include "tests/sim/altered_engine.hpp"

namespace gnomon::pipeline {

/// A cube with an unused vertex, on the usual ground; `directory` must be writable and is left as it was.
scene::Scene small_scene(const std::filesystem::path& directory);

/// The rtl engine's interface on golden, with `alteration` of its answers: an engine under test that needs no
/// compiler.
RtlFactory stand_in(const sim::test::Alteration& alteration = nullptr);
/// Hangs at the first drain.
RtlFactory hanging_stand_in();

/// Each test's own empty directory, and a request that writes into it.
class RunTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override { std::filesystem::remove_all(root_); }

  /// The small scene at 24 voxels a side, on the stand-in.
  RunRequest request() const;
  std::filesystem::path output() const { return root_ / "out"; }
  std::string content(const char* file) const;
  nlohmann::json metrics() const { return nlohmann::json::parse(content("metrics.json")); }

  std::filesystem::path root_;
};

}  // namespace gnomon::pipeline
