// SPDX-License-Identifier: Apache-2.0
// The machine by loads and stores: addresses are the hardware's own.
#include "firmware/driver/platform.h"

#include "firmware/target/csr.h"

uint32_t platform_read(uintptr_t address) {
  return *(volatile uint32_t*)address;
}

void platform_write(uintptr_t address, uint32_t value) {
  *(volatile uint32_t*)address = value;
}

void* platform_memory(uint32_t address) {
  return (void*)(uintptr_t)address;
}

void platform_barrier(void) {
  __asm__ volatile("fence" ::: "memory");
}

uint32_t platform_instructions(void) {
  return CSR_READ(minstret);
}
