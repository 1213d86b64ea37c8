// SPDX-License-Identifier: Apache-2.0
// The library's callbacks are plain functions without context, which is why this file needs one shared
// registry.
#include "host/surface/osd_warnings.hpp"

#include <opensubdiv/far/error.h>

#include <map>
#include <mutex>
#include <utility>

namespace gnomon::surface {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<const void*, std::vector<std::string>> sinks;

  static Registry& instance() {
    static Registry registry;
    return registry;
  }
  void add(const char* message) {
    const std::lock_guard lock(mutex);
    for (auto& [owner, messages] : sinks) messages.emplace_back(message);
  }
};

void on_warning(const char* message) {
  Registry::instance().add(message);
}
void on_error(OpenSubdiv::Far::ErrorType, const char* message) {
  Registry::instance().add(message);
}

}  // namespace

OsdWarnings::OsdWarnings() {
  Registry& registry = Registry::instance();
  const std::lock_guard lock(registry.mutex);
  registry.sinks[this];
  OpenSubdiv::Far::SetWarningCallback(on_warning);
  OpenSubdiv::Far::SetErrorCallback(on_error);
}

OsdWarnings::~OsdWarnings() {
  Registry& registry = Registry::instance();
  const std::lock_guard lock(registry.mutex);
  registry.sinks.erase(this);
}

std::vector<std::string> OsdWarnings::take() {
  Registry& registry = Registry::instance();
  const std::lock_guard lock(registry.mutex);
  return std::exchange(registry.sinks[this], {});
}

}  // namespace gnomon::surface
