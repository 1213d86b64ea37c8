// SPDX-License-Identifier: Apache-2.0
// The environment's say in how models are made.
#include "sim/toolchain.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace gnomon::sim {

namespace {

std::string environment(const char* name, const std::string& fallback = {}) {
  const char* value = std::getenv(name);
  return value && *value ? std::string(value) : fallback;
}

std::filesystem::path cache_dir_from_environment() {
  if (const std::string dir = environment("GNOMON_CACHE_DIR"); !dir.empty()) return dir;
  if (const std::string dir = environment("XDG_CACHE_HOME"); !dir.empty())
    return std::filesystem::path(dir) / "gnomon";
  if (const std::string dir = environment("HOME"); !dir.empty())
    return std::filesystem::path(dir) / ".cache" / "gnomon";
  throw std::runtime_error("no folder for compiled models: set GNOMON_CACHE_DIR");
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

Toolchain Toolchain::from_environment() {
  Toolchain tools;
  tools.cache_dir = std::filesystem::absolute(cache_dir_from_environment());
  tools.prebuilt_dir = GNOMON_BUILT_WITH_PREBUILT_DIR;
  tools.rtl_dir = std::filesystem::absolute(environment("GNOMON_RTL_DIR", GNOMON_BUILT_WITH_RTL_DIR));
  tools.verilator = environment("VERILATOR", GNOMON_BUILT_WITH_VERILATOR);
  tools.verilator_root = environment("VERILATOR_ROOT", GNOMON_BUILT_WITH_VERILATOR_ROOT);
  if (const std::string launcher = GNOMON_BUILT_WITH_LAUNCHER; std::filesystem::exists(launcher)) {
    tools.compiler.push_back(launcher);
  }
  tools.compiler.push_back(environment("GNOMON_CXX", GNOMON_BUILT_WITH_CXX));
  return tools;
}

std::string version_of(const std::string& program) {
  const std::string command = quoted(program) + " --version 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string said;
  std::array<char, 256> part{};
  while (pipe && std::fgets(part.data(), static_cast<int>(part.size()), pipe)) said += part.data();
  if (!pipe || pclose(pipe) != 0 || said.empty()) throw std::runtime_error("'" + program + "' does not run");
  return said.substr(0, said.find('\n') + 1);
}

std::string Toolchain::versions() const try {
  return version_of(verilator) + version_of(compiler.back());
} catch (const std::runtime_error& missing) {
  throw std::runtime_error(std::string(missing.what()) +
                           "; compiled models need Verilator and a C++ compiler");
}

}  // namespace gnomon::sim
