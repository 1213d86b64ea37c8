// SPDX-License-Identifier: Apache-2.0
// Control and status registers by name.
#ifndef GNOMON_TARGET_CSR_H
#define GNOMON_TARGET_CSR_H

#include <stdint.h>

#define CSR_READ(name)                                  \
  ({                                                    \
    uint32_t value_;                                    \
    __asm__ volatile("csrr %0, " #name : "=r"(value_)); \
    value_;                                             \
  })
#define CSR_SET(name, bits) __asm__ volatile("csrs " #name ", %0" : : "r"(bits) : "memory")
#define CSR_CLEAR(name, bits) __asm__ volatile("csrc " #name ", %0" : : "r"(bits) : "memory")

enum { MSTATUS_MIE = 1 << 3 };
enum { MIE_SOFTWARE = 1 << 3, MIE_TIMER = 1 << 7, MIE_EXTERNAL = 1 << 11 };

#endif
