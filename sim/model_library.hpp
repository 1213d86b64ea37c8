// SPDX-License-Identifier: Apache-2.0
// A compiled model, loaded into this process.
#pragma once

#include <filesystem>

#include "sim/model/model_abi.h"

namespace gnomon::sim {

/// The shared object stays loaded as long as this lives; any number of models can be created from it.
class ModelLibrary {
 public:
  /// Throws std::runtime_error if the file is not a model of this version.
  explicit ModelLibrary(const std::filesystem::path& path);
  ~ModelLibrary();
  ModelLibrary(const ModelLibrary&) = delete;
  ModelLibrary& operator=(const ModelLibrary&) = delete;

  const GnomonModelApi& api() const { return *api_; }

 private:
  void* handle_ = nullptr;
  const GnomonModelApi* api_ = nullptr;
};

}  // namespace gnomon::sim
