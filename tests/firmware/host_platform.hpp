// SPDX-License-Identifier: Apache-2.0
// The driver's platform on the host: a mock system.
#pragma once

#include "tests/firmware/mock_system.hpp"

namespace gnomon::firmware::test {

/// The system that platform_* reach, as long as this lives. An access that the bus refuses fails the test.
class HostPlatform {
 public:
  explicit HostPlatform(MockSystem& system);
  ~HostPlatform();
  HostPlatform(const HostPlatform&) = delete;
  HostPlatform& operator=(const HostPlatform&) = delete;
};

}  // namespace gnomon::firmware::test
