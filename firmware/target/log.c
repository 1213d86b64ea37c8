// SPDX-License-Identifier: Apache-2.0
// picolibc's stdout.
#include "firmware/target/log.h"

#include <stdio.h>

#include "firmware/driver/gnomon_registers.h"
#include "firmware/driver/platform.h"
#include "firmware/target/csr.h"

static int put(char character, FILE* file) {
  (void)file;
  platform_write(GNOMON_MAILBOX_BASE + GNOMON_MAILBOX_LOG_OFFSET, (uint8_t)character);
  return 0;
}

static FILE mailbox_stream = FDEV_SETUP_STREAM(put, NULL, NULL, _FDEV_SETUP_WRITE);
FILE* const stdout = &mailbox_stream;

void fail(uint32_t failure) {
  platform_write(GNOMON_MAILBOX_BASE + GNOMON_MAILBOX_FAILURE_OFFSET, failure);
  platform_write(GNOMON_MAILBOX_BASE + GNOMON_MAILBOX_STATE_OFFSET, GNOMON_MAILBOX_STATE_IS_FAILED);
  CSR_CLEAR(mie, MIE_SOFTWARE | MIE_TIMER | MIE_EXTERNAL);
  for (;;) __asm__ volatile("wfi");
}
