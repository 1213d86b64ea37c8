// SPDX-License-Identifier: Apache-2.0
// Interrupts become events; exceptions are faults of the firmware.
#ifndef GNOMON_TARGET_TRAP_H
#define GNOMON_TARGET_TRAP_H

#include <stdint.h>

#include "firmware/driver/gnomon_driver.h"

/// Whose interrupts the handler takes; then lets them come.
void trap_start(const gnomon_device* device);

/// Sleeps until something has happened; what (job_runner.h). Interrupts are off on return.
uint32_t trap_wait(void);

#endif
