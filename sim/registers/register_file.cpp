// SPDX-License-Identifier: Apache-2.0
// Rules of access.
#include "sim/registers/register_file.hpp"

#include <algorithm>
#include <stdexcept>

namespace gnomon::sim::registers {
namespace {

constexpr std::uint32_t kBlockBytes = 4096;

bool holds(const RegisterInfo& info, std::uint32_t offset) {
  if (offset < info.offset) return false;
  const std::uint32_t distance = offset - info.offset;
  return distance % info.stride == 0 && distance / info.stride < info.count;
}

}  // namespace

RegisterFile::RegisterFile(std::span<const RegisterInfo> table) : table_(table), values_(kBlockBytes / 4) {
  reset();
}

const RegisterInfo* RegisterFile::find(std::uint32_t offset) const {
  const auto found = std::find_if(table_.begin(), table_.end(),
                                  [&](const RegisterInfo& info) { return holds(info, offset); });
  return found == table_.end() ? nullptr : &*found;
}

const RegisterInfo& RegisterFile::known(std::uint32_t offset) const {
  const RegisterInfo* const info = find(offset);
  if (info == nullptr) throw std::out_of_range("no register at this offset");
  return *info;
}

std::optional<std::uint32_t> RegisterFile::read(std::uint32_t offset) const {
  if (find(offset) == nullptr) return std::nullopt;
  return values_[offset / 4];
}

bool RegisterFile::write(std::uint32_t offset, std::uint32_t value) {
  const RegisterInfo* const info = find(offset);
  if (info == nullptr) return false;
  std::uint32_t& stored = values_[offset / 4];
  if (info->access == Access::Rw) stored = value & info->mask;
  if (info->access == Access::W1c) stored &= ~value;
  return true;
}

std::uint32_t RegisterFile::get(std::uint32_t offset) const {
  static_cast<void>(known(offset));
  return values_[offset / 4];
}

void RegisterFile::set(std::uint32_t offset, std::uint32_t value) {
  values_[offset / 4] = value & known(offset).mask;
}

void RegisterFile::reset() {
  for (const RegisterInfo& info : table_)
    for (std::uint32_t i = 0; i < info.count; ++i) values_[(info.offset + i * info.stride) / 4] = info.reset;
}

}  // namespace gnomon::sim::registers
