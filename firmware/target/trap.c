// SPDX-License-Identifier: Apache-2.0
// The trap handler, and sleep without a lost wake-up.
#include "firmware/target/trap.h"

#include <stdio.h>

#include "firmware/driver/gnomon_registers.h"
#include "firmware/driver/job_runner.h"
#include "firmware/driver/platform.h"
#include "firmware/target/csr.h"
#include "firmware/target/log.h"

enum { kSoftware = 3, kTimer = 7, kExternal = 11 };

static const gnomon_device* handled;
static volatile uint32_t happened;

static void take_exception(uint32_t cause) {
  const uint32_t from = CSR_READ(mepc);
  const uint32_t value = CSR_READ(mtval);
  printf("trap: cause %u at 0x%08x, value 0x%08x\n", (unsigned)cause, (unsigned)from, (unsigned)value);
  fail(GNOMON_MAILBOX_FAILURE_IS_TRAP);
}

static uint32_t take_interrupt(uint32_t code) {
  switch (code) {
    case kExternal:
      return gnomon_take_interrupts(handled);
    case kSoftware:
      platform_write(GNOMON_MAILBOX_BASE + GNOMON_MAILBOX_DOORBELL_OFFSET, GNOMON_MAILBOX_DOORBELL_RUNG_MASK);
      return GNOMON_EVENT_DOORBELL;
    default:
      job_runner_stop_watchdog();
      return GNOMON_EVENT_WATCHDOG;
  }
}

__attribute__((interrupt("machine"), aligned(4), used)) void trap_handler(void) {
  const uint32_t cause = CSR_READ(mcause);
  if (cause >> 31U == 0) take_exception(cause);
  happened |= take_interrupt(cause & 0x7FFFFFFFU);
}

void trap_start(const gnomon_device* device) {
  handled = device;
  CSR_SET(mie, MIE_SOFTWARE | MIE_TIMER | MIE_EXTERNAL);
}

uint32_t trap_wait(void) {
  for (;;) {
    CSR_CLEAR(mstatus, MSTATUS_MIE);
    const uint32_t events = happened;
    happened = 0;
    if (events != 0) return events;
    // Wakes although interrupts are off, so none can slip in between the look and the sleep.
    __asm__ volatile("wfi");
    CSR_SET(mstatus, MSTATUS_MIE);
  }
}
