// SPDX-License-Identifier: Apache-2.0
// dlopen, and a check of the interface's version.
#include "sim/model_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace gnomon::sim {

namespace {

/// What the object's only function gives, if it is of version `abi`.
template <class Api>
const Api* interface_of(const SharedObject& object, const char* function, std::uint32_t abi,
                        const std::filesystem::path& path) {
  using GetApi = const Api* (*)();
  const auto get = reinterpret_cast<GetApi>(object.symbol(function));
  const Api* const api = get ? get() : nullptr;
  if (!api || api->abi != abi) throw std::runtime_error("not a model of this version: " + path.string());
  return api;
}

}  // namespace

SharedObject::SharedObject(const std::filesystem::path& path)
    : handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (!handle_) throw std::runtime_error(std::string("cannot load the compiled model: ") + dlerror());
}

SharedObject::~SharedObject() {
  dlclose(handle_);
}

void* SharedObject::symbol(const char* name) const {
  return dlsym(handle_, name);
}

ModelLibrary::ModelLibrary(const std::filesystem::path& path)
    : object_(path),
      api_(interface_of<GnomonModelApi>(object_, "gnomon_model_api", GNOMON_MODEL_ABI, path)) {}

TopLibrary::TopLibrary(const std::filesystem::path& path)
    : object_(path), api_(interface_of<GnomonTopApi>(object_, "gnomon_top_api", GNOMON_TOP_ABI, path)) {}

}  // namespace gnomon::sim
