// SPDX-License-Identifier: Apache-2.0
// gnomon_build_models: puts the default model into the cache while the project is built, so that the first
// run does not wait for it.
#include <cstdio>
#include <exception>

#include "sim/model_cache.hpp"

int main() {
  try {
    gnomon::sim::ModelCache cache(gnomon::sim::Toolchain::from_environment(),
                                  [](const std::string& notice) { std::printf("%s\n", notice.c_str()); });
    cache.load({});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
  return 0;
}
