// SPDX-License-Identifier: Apache-2.0
// Compiled models of the hardware, made when first asked for and kept for the next time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/artifact_cache.hpp"
#include "sim/model_library.hpp"
#include "sim/model_spec.hpp"
#include "sim/toolchain.hpp"

namespace gnomon::sim {

/// A model could not be made. The message names the first error that Verilator or the compiler gave.
class ModelBuildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Finds a model by everything it is made from: RTL, driver, parameters, tools and their versions, flags.
class ModelCache {
 public:
  /// Called with one line before something that takes seconds.
  using Notice = std::function<void(const std::string&)>;

  explicit ModelCache(Toolchain tools = Toolchain::from_environment(), Notice notice = {});

  /// The model, built if it is not in the cache. Throws ModelBuildError if the RTL refuses the parameters or
  /// does not compile.
  std::shared_ptr<const ModelLibrary> load(const ModelSpec& spec);
  /// The same of gnomon_top, whatever spec.top says.
  std::shared_ptr<const TopLibrary> load_top(ModelSpec spec);

  /// Asks Verilator alone, without compiling: nothing if the RTL accepts the spec, else its first error line.
  std::optional<std::string> refusal(const ModelSpec& spec) const;

  /// Models compiled by this object; 0 means that the cache had them all.
  int built() const { return built_; }
  /// The folder that holds (or would hold) the model and its build log.
  std::filesystem::path entry(const ModelSpec& spec) const;

 private:
  Artifact artifact(const ModelSpec& spec) const;
  /// The shared object, built if it is not in the cache.
  std::filesystem::path product(const ModelSpec& spec);
  std::filesystem::path runtime();
  void build_runtime(const std::filesystem::path& work) const;
  void build_model(const ModelSpec& spec, const std::filesystem::path& work);

  Toolchain tools_;
  Notice notice_;
  ArtifactCache artifacts_;
  std::string versions_;
  int built_ = 0;
};

}  // namespace gnomon::sim
