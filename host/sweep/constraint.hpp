// SPDX-License-Identifier: Apache-2.0
// Which combinations of parameters a sweep measures. Theory: docs/sweep.md, "Specification".
#pragma once

#include <memory>
#include <string>

#include "host/base/result.hpp"
#include "host/config/settings.hpp"

namespace mu {
class Parser;
}

namespace gnomon::sweep {

/// An expression over all parameters in muParser's language; words in quotes stand for themselves.
class Constraint {
 public:
  /// Fails with muParser's reason where it is no such expression or names an unknown parameter.
  static Result<Constraint> parse(const std::string& text);

  Constraint(Constraint&&) noexcept;
  Constraint& operator=(Constraint&&) noexcept;
  ~Constraint();

  /// True where the expression is not zero; not a number counts as zero.
  bool holds(const config::Settings& settings);

 private:
  struct Variables;
  Constraint();
  void assign(const config::Settings& settings);

  std::unique_ptr<Variables> variables_;
  std::unique_ptr<mu::Parser> parser_;  ///< refers to *variables_
};

}  // namespace gnomon::sweep
