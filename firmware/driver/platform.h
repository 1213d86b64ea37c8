// SPDX-License-Identifier: Apache-2.0
// All that the driver asks of the machine it runs on. The target's answers are in firmware/target/platform.c,
// a test has its own.
#ifndef GNOMON_PLATFORM_H
#define GNOMON_PLATFORM_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

uint32_t platform_read(uintptr_t address);
void platform_write(uintptr_t address, uint32_t value);
/// Memory that the hardware shares, by the address that the hardware uses.
void* platform_memory(uint32_t address);
/// What was written to shared memory is seen before what is written next.
void platform_barrier(void);
/// Instructions executed so far.
uint32_t platform_instructions(void);

#ifdef __cplusplus
}
#endif

#endif
