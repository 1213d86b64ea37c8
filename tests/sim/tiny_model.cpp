// SPDX-License-Identifier: Apache-2.0
// Helpers around the stand-in RTL.
#include "tests/sim/tiny_model.hpp"

#include <cstdlib>
#include <gnomon/golden/codec.hpp>
#include <stdexcept>

namespace gnomon::sim::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "gnomon-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Toolchain tiny_tools(const fs::path& cache_dir) {
  Toolchain tools = Toolchain::from_environment();
  tools.rtl_dir = TINY_RTL_DIR;
  tools.prebuilt_dir.clear();
  if (!cache_dir.empty()) tools.cache_dir = cache_dir;
  return tools;
}

std::unique_ptr<RtlEngine> tiny_engine(const RtlOptions& options) {
  ModelCache cache(tiny_tools());
  return make_rtl_engine({}, options, cache);
}

std::vector<Word> fences(std::uint32_t first, std::uint32_t count) {
  std::vector<Word> words;
  for (std::uint32_t i = 0; i < count; ++i) {
    words.push_back(
        golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::Fence), 0, 0, first + i}));
  }
  return words;
}

std::vector<Word> run(golden::Engine& engine, std::span<const Word> words) {
  std::vector<Word> results;
  engine.submit(words);
  engine.drain([&](std::span<const Word> more) { results.insert(results.end(), more.begin(), more.end()); });
  return results;
}

}  // namespace gnomon::sim::test
