// SPDX-License-Identifier: Apache-2.0
// How functions of the host report that their input cannot be used.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace gnomon {

/// One clear line for the user: where (file, line or key), what was found, what was expected.
/// The program prints it on stderr as "gnomon: error: <message>" and exits with 2.
struct Error {
  std::string message;
};

/// A value, or the reason why the input cannot give one. Internal faults are exceptions (exit 3), never
/// Errors.
template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string message) {
  return tl::make_unexpected(Error{std::move(message)});
}

}  // namespace gnomon
