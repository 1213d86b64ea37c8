// SPDX-License-Identifier: Apache-2.0
// printf goes to the mailbox, a character a write.
#ifndef GNOMON_TARGET_LOG_H
#define GNOMON_TARGET_LOG_H

#include <stdint.h>

/// Says in the mailbox why the firmware cannot go on, and sleeps for ever.
__attribute__((noreturn)) void fail(uint32_t failure);

#endif
