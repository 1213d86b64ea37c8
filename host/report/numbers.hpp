// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace gnomon::report {

/// 1234567 -> "1,234,567".
std::string with_commas(std::uint64_t value);
/// part of whole in per cent with three digits behind the point; "–" where the whole is 0.
std::string percent(double share);
/// 0.00123 -> "1.23 ms"; three significant digits, s, ms, µs or ns.
std::string duration(double seconds);
/// 8388608 -> "8.39 Mbit"; three significant digits, decimal prefixes.
std::string bits(std::uint64_t count);
/// `digits` digits behind the point.
std::string fixed(double value, int digits);
/// The words as one line for a POSIX shell.
std::string shell_line(std::span<const std::string> words);

}  // namespace gnomon::report
