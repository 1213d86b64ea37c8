// SPDX-License-Identifier: Apache-2.0
// Jobs of the mailbox, one after the other: start, completion, retry, fallback, watchdog, report
// (docs/firmware.md).
#ifndef GNOMON_JOB_RUNNER_H
#define GNOMON_JOB_RUNNER_H

#include <stdbool.h>
#include <stdint.h>

#include "firmware/driver/gnomon_driver.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A place of the job table: what the host writes, then the report.
typedef struct {
  uint32_t address, words;
  uint32_t fallback_address, fallback_words, fallback_flags;
  uint32_t retries;
  uint32_t watchdog;
  uint32_t reserved;
  uint32_t outcome;
  uint32_t results_begin, results_end;
  uint32_t flags, errors;
  uint32_t attempts;
  uint32_t error;
  uint32_t instructions;
} gnomon_job;

enum { GNOMON_JOB_ERROR_WATCHDOG = 0x100 };

/// What has happened since it was last looked: the hardware's interrupt bits, and two more.
enum { GNOMON_EVENT_DOORBELL = 1 << 30, GNOMON_EVENT_WATCHDOG = 1 << 29 };

typedef struct {
  gnomon_device* device;
  uint32_t table, table_log2;
  uint32_t next;  // number of the job to be run next, or running
  bool running, in_fallback;
  uint32_t place;            // of the descriptor under way
  uint32_t results_begin;    // of this attempt
  uint32_t attempts, error;  // of this job
  uint32_t instructions;     // when the job was begun
} job_runner;

/// Rings, table and planes from the mailbox; starts the hardware. One of GNOMON_MAILBOX_FAILURE_IS_*.
uint32_t job_runner_open(job_runner* runner, gnomon_device* device);

/// Does what the events ask for, and begins jobs. One of GNOMON_MAILBOX_FAILURE_IS_*; any but NONE is final.
uint32_t job_runner_handle(job_runner* runner, uint32_t events);

/// Switches the watchdog's timer off.
void job_runner_stop_watchdog(void);

#ifdef __cplusplus
}
#endif

#endif
