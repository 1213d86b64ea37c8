// SPDX-License-Identifier: Apache-2.0
// Engines around the stand-in of tests/sim/tiny_rtl, in a cache of their own: what is under test is the
// machinery, not the RTL.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/rtl_engine.hpp"

namespace gnomon::sim::test {

/// A folder that is gone after the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Tools with the stand-in's RTL and no prebuilt models. `cache_dir` empty: the cache that all tests share.
Toolchain tiny_tools(const std::filesystem::path& cache_dir = {});

/// An engine around the stand-in, from the shared cache.
std::unique_ptr<RtlEngine> tiny_engine(const RtlOptions& options = {});

/// `count` FENCE commands with the tags first, first + 1, ...
std::vector<Word> fences(std::uint32_t first, std::uint32_t count);

/// Everything the engine gives.
std::vector<Word> run(golden::Engine& engine, std::span<const Word> words);

}  // namespace gnomon::sim::test
