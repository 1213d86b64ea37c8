// SPDX-License-Identifier: Apache-2.0
// A compiled model, loaded into this process.
#pragma once

#include <filesystem>

#include "sim/model/model_abi.h"
#include "sim/model/top_abi.h"

namespace gnomon::sim {

/// A shared object that stays loaded as long as this lives.
class SharedObject {
 public:
  /// Throws std::runtime_error if the file cannot be loaded.
  explicit SharedObject(const std::filesystem::path& path);
  ~SharedObject();
  SharedObject(const SharedObject&) = delete;
  SharedObject& operator=(const SharedObject&) = delete;

  /// Null where it has none of that name.
  void* symbol(const char* name) const;

 private:
  void* handle_ = nullptr;
};

/// Of gnomon_core; any number of models can be created from it.
class ModelLibrary {
 public:
  /// Throws std::runtime_error if the file is not a model of this version.
  explicit ModelLibrary(const std::filesystem::path& path);
  const GnomonModelApi& api() const { return *api_; }

 private:
  SharedObject object_;
  const GnomonModelApi* api_ = nullptr;
};

/// Of gnomon_top.
class TopLibrary {
 public:
  /// Throws std::runtime_error if the file is not a model of this version.
  explicit TopLibrary(const std::filesystem::path& path);
  const GnomonTopApi& api() const { return *api_; }

 private:
  SharedObject object_;
  const GnomonTopApi* api_ = nullptr;
};

}  // namespace gnomon::sim
