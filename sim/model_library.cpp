// SPDX-License-Identifier: Apache-2.0
// dlopen, and a check of the interface's version.
#include "sim/model_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace gnomon::sim {

ModelLibrary::ModelLibrary(const std::filesystem::path& path)
    : handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw std::runtime_error(std::string("cannot load the compiled model: ") + dlerror());
  using GetApi = const GnomonModelApi* (*)();
  const auto get = reinterpret_cast<GetApi>(dlsym(handle_, "gnomon_model_api"));
  api_ = get ? get() : nullptr;
  if (!api_ || api_->abi != GNOMON_MODEL_ABI) {
    dlclose(handle_);
    throw std::runtime_error("not a model of this version: " + path.string());
  }
}

ModelLibrary::~ModelLibrary() {
  dlclose(handle_);
}

}  // namespace gnomon::sim
