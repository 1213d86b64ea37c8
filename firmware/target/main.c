// SPDX-License-Identifier: Apache-2.0
// The command loop.
#include <stdio.h>

#include "firmware/driver/gnomon_driver.h"
#include "firmware/driver/gnomon_registers.h"
#include "firmware/driver/job_runner.h"
#include "firmware/driver/platform.h"
#include "firmware/target/log.h"
#include "firmware/target/trap.h"

static uint32_t failure_of(gnomon_result result) {
  switch (result) {
    case GNOMON_WRONG_VERSION:
      return GNOMON_MAILBOX_FAILURE_IS_WRONG_VERSION;
    case GNOMON_NO_RINGS:
      return GNOMON_MAILBOX_FAILURE_IS_NO_RINGS;
    default:
      return GNOMON_MAILBOX_FAILURE_IS_NO_HARDWARE;
  }
}

static void greet(const gnomon_capabilities* capabilities) {
  printf("gnomon firmware: hardware %u.%u, features 0x%05x, voxels 2^%u, plane 2^%u, depth %u bits\n",
         (unsigned)(capabilities->version >> GNOMON_VERSION_MAJOR_SHIFT),
         (unsigned)(capabilities->version & GNOMON_VERSION_MINOR_MASK), (unsigned)capabilities->features,
         capabilities->voxel_bits, capabilities->plane_log2, capabilities->depth_bits);
}

int main(void) {
  static gnomon_device device;
  static gnomon_capabilities capabilities;
  static job_runner runner;
  const gnomon_result found = gnomon_probe(&device, GNOMON_BASE, &capabilities);
  if (found != GNOMON_OK) fail(failure_of(found));
  uint32_t failure = job_runner_open(&runner, &device);
  if (failure != GNOMON_MAILBOX_FAILURE_IS_NONE) fail(failure);
  greet(&capabilities);
  trap_start(&device);
  failure = job_runner_handle(&runner, 0);  // jobs posted before the start
  while (failure == GNOMON_MAILBOX_FAILURE_IS_NONE) failure = job_runner_handle(&runner, trap_wait());
  fail(failure);
}
