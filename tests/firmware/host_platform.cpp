// SPDX-License-Identifier: Apache-2.0
// C functions, so the system that they reach has to be known to the file.
#include "tests/firmware/host_platform.hpp"

#include <gtest/gtest.h>

#include "firmware/driver/platform.h"

namespace gnomon::firmware::test {
namespace {

MockSystem* current = nullptr;

}  // namespace

HostPlatform::HostPlatform(MockSystem& system) {
  current = &system;
}
HostPlatform::~HostPlatform() {
  current = nullptr;
}

extern "C" {

std::uint32_t platform_read(std::uintptr_t address) {
  const sim::cpu::Reply reply = current->read(static_cast<std::uint32_t>(address), 4, sim::cpu::Access::Load);
  if (reply.fault) ADD_FAILURE() << "the bus refuses to read " << std::hex << address;
  return reply.data;
}
void platform_write(std::uintptr_t address, std::uint32_t value) {
  if (current->write(static_cast<std::uint32_t>(address), 4, value).fault)
    ADD_FAILURE() << "the bus refuses to write " << std::hex << address;
}
void* platform_memory(std::uint32_t address) {
  return &current->dram.bytes.at(address - Dram::kBase);
}
void platform_barrier() {}
std::uint32_t platform_instructions() {
  return 0;
}

}  // extern "C"

}  // namespace gnomon::firmware::test
