// SPDX-License-Identifier: Apache-2.0
// Values of a block of registers, with the rules of access; a device puts its behaviour around it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/registers/register_info.hpp"

namespace gnomon::sim::registers {

class RegisterFile {
 public:
  /// The table must outlive the file.
  explicit RegisterFile(std::span<const RegisterInfo> table);

  /// The register at this offset, or null.
  const RegisterInfo* find(std::uint32_t offset) const;
  /// As software does; nothing (false) where there is no register.
  std::optional<std::uint32_t> read(std::uint32_t offset) const;
  bool write(std::uint32_t offset, std::uint32_t value);

  /// As hardware does. Throws std::out_of_range where there is no register; bits that do not exist are
  /// dropped.
  std::uint32_t get(std::uint32_t offset) const;
  void set(std::uint32_t offset, std::uint32_t value);
  /// All values as after reset.
  void reset();

 private:
  const RegisterInfo& known(std::uint32_t offset) const;

  std::span<const RegisterInfo> table_;
  std::vector<std::uint32_t> values_;  ///< a word of the block each
};

}  // namespace gnomon::sim::registers
