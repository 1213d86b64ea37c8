// SPDX-License-Identifier: Apache-2.0
// The life of a job.
#include "firmware/driver/job_runner.h"

#include <stddef.h>

#include "firmware/driver/gnomon_registers.h"
#include "firmware/driver/platform.h"

enum { kJobBytes = 64, kMaxTableLog2 = 16 };

_Static_assert(sizeof(gnomon_job) == kJobBytes, "a place of the job table");
_Static_assert(sizeof(gnomon_descriptor) == 16 && sizeof(gnomon_completion) == 16,
               "a place of the command ring");

static uint32_t mailbox(uint32_t offset) {
  return platform_read(GNOMON_MAILBOX_BASE + offset);
}

static void set_mailbox(uint32_t offset, uint32_t value) {
  platform_write(GNOMON_MAILBOX_BASE + offset, value);
}

static volatile gnomon_job* job_at(const job_runner* runner, uint32_t number) {
  return platform_memory(runner->table + (number & ((1U << runner->table_log2) - 1U)) * kJobBytes);
}

static uint64_t time_now(void) {
  uint32_t high = 0;
  uint32_t low = 0;
  do {
    high = platform_read(GNOMON_TIMER_BASE + GNOMON_TIMER_TIME_HIGH_OFFSET);
    low = platform_read(GNOMON_TIMER_BASE + GNOMON_TIMER_TIME_LOW_OFFSET);
  } while (high != platform_read(GNOMON_TIMER_BASE + GNOMON_TIMER_TIME_HIGH_OFFSET));
  return (uint64_t)high << 32U | low;
}

// The high half is moved out of reach first, so that no value between the two is met.
static void set_watchdog(uint64_t time) {
  platform_write(GNOMON_TIMER_BASE + GNOMON_TIMER_COMPARE_HIGH_OFFSET, UINT32_MAX);
  platform_write(GNOMON_TIMER_BASE + GNOMON_TIMER_COMPARE_LOW_OFFSET, (uint32_t)time);
  platform_write(GNOMON_TIMER_BASE + GNOMON_TIMER_COMPARE_HIGH_OFFSET, (uint32_t)(time >> 32U));
}

void job_runner_stop_watchdog(void) {
  set_watchdog(UINT64_MAX);
}

static void restart_watchdog(const job_runner* runner) {
  const uint32_t cycles = job_at(runner, runner->next)->watchdog;
  if (cycles != 0) set_watchdog(time_now() + cycles);
}

uint32_t job_runner_open(job_runner* runner, gnomon_device* device) {
  *runner = (job_runner){.device = device,
                         .table = mailbox(GNOMON_MAILBOX_JOB_TABLE_OFFSET),
                         .table_log2 = mailbox(GNOMON_MAILBOX_JOB_TABLE_LOG2_OFFSET)};
  device->commands.address = mailbox(GNOMON_MAILBOX_COMMAND_RING_OFFSET);
  device->commands.log2 = mailbox(GNOMON_MAILBOX_COMMAND_RING_LOG2_OFFSET);
  device->results.address = mailbox(GNOMON_MAILBOX_RESULT_RING_OFFSET);
  device->results.log2 = mailbox(GNOMON_MAILBOX_RESULT_RING_LOG2_OFFSET);
  device->planes = mailbox(GNOMON_MAILBOX_PLANES_OFFSET);
  if (runner->table_log2 > kMaxTableLog2 || runner->table % kJobBytes != 0)
    return GNOMON_MAILBOX_FAILURE_IS_BAD_MAILBOX;
  if (gnomon_start(device, 0, 0) != GNOMON_OK) return GNOMON_MAILBOX_FAILURE_IS_BAD_MAILBOX;
  return GNOMON_MAILBOX_FAILURE_IS_NONE;
}

// The hardware is idle and the ring is empty, so there is room.
static void begin_attempt(job_runner* runner, uint32_t address, uint32_t words) {
  runner->running = true;
  runner->results_begin = gnomon_results_head(runner->device);
  ++runner->attempts;
  restart_watchdog(runner);
  gnomon_submit(runner->device, address, words, (uint16_t)runner->next, &runner->place);
}

static void begin_stream(job_runner* runner) {
  const volatile gnomon_job* const job = job_at(runner, runner->next);
  if (runner->in_fallback)
    begin_attempt(runner, job->fallback_address, job->fallback_words);
  else
    begin_attempt(runner, job->address, job->words);
}

static void publish_results(const job_runner* runner) {
  set_mailbox(GNOMON_MAILBOX_RESULTS_READY_OFFSET, gnomon_results_head(runner->device));
}

static void finish(job_runner* runner, uint32_t outcome, const gnomon_completion* completion) {
  volatile gnomon_job* const job = job_at(runner, runner->next);
  job_runner_stop_watchdog();
  job->results_begin = runner->results_begin;
  job->results_end = completion->results;
  job->flags = completion->flags;
  job->errors = completion->errors;
  job->attempts = runner->attempts;
  job->error = runner->error;
  job->instructions = platform_instructions() - runner->instructions;
  job->outcome = outcome;
  platform_barrier();
  runner->running = false;
  ++runner->next;
  publish_results(runner);
  set_mailbox(GNOMON_MAILBOX_JOBS_FINISHED_OFFSET, runner->next);
}

/// An end without results.
static void finish_empty(job_runner* runner, uint32_t outcome) {
  const gnomon_completion none = {.results = runner->results_begin};
  finish(runner, outcome, &none);
}

static bool is_stream(uint32_t address, uint32_t words) {
  return words != 0 && address % 8 == 0;
}

static bool may_run(const volatile gnomon_job* job) {
  return is_stream(job->address, job->words) &&
         (job->fallback_words == 0 || is_stream(job->fallback_address, job->fallback_words));
}

static void begin_job(job_runner* runner) {
  runner->in_fallback = false;
  runner->attempts = 0;
  runner->error = 0;
  runner->instructions = platform_instructions();
  if (may_run(job_at(runner, runner->next))) {
    begin_stream(runner);
  } else {
    runner->results_begin = gnomon_results_head(runner->device);
    finish_empty(runner, GNOMON_MAILBOX_OUTCOME_IS_REFUSED);
  }
}

static void complete_attempt(job_runner* runner, const gnomon_completion* completion) {
  const volatile gnomon_job* const job = job_at(runner, runner->next);
  if (runner->in_fallback) {
    finish(runner, GNOMON_MAILBOX_OUTCOME_IS_FALLBACK, completion);
  } else if ((completion->flags & job->fallback_flags) != 0 && job->fallback_words != 0) {
    runner->in_fallback = true;
    begin_stream(runner);
  } else {
    finish(runner, GNOMON_MAILBOX_OUTCOME_IS_DONE, completion);
  }
}

/// Resets the hardware and begins the attempt again, or gives the job up.
static uint32_t recover(job_runner* runner, uint32_t error) {
  const uint32_t results = gnomon_results_head(runner->device);
  const uint32_t allowed = job_at(runner, runner->next)->retries + (runner->in_fallback ? 2U : 1U);
  runner->error = error;
  job_runner_stop_watchdog();
  if (gnomon_reset(runner->device) != GNOMON_OK) return GNOMON_MAILBOX_FAILURE_IS_NO_RESET;
  gnomon_start(runner->device, results, mailbox(GNOMON_MAILBOX_RESULTS_TAKEN_OFFSET));
  if (runner->attempts < allowed) {
    begin_stream(runner);
  } else {
    runner->results_begin = results;
    finish_empty(runner, GNOMON_MAILBOX_OUTCOME_IS_FAILED);
  }
  return GNOMON_MAILBOX_FAILURE_IS_NONE;
}

/// The job under way: complete, failed, late, or waiting for room.
static uint32_t follow_job(job_runner* runner, uint32_t events) {
  gnomon_completion completion = {0};
  if (gnomon_complete(runner->device, runner->place, &completion)) {
    complete_attempt(runner, &completion);
    return GNOMON_MAILBOX_FAILURE_IS_NONE;
  }
  const uint32_t error = gnomon_error(runner->device);
  if (error != 0) return recover(runner, error);
  if ((events & GNOMON_EVENT_WATCHDOG) != 0) return recover(runner, GNOMON_JOB_ERROR_WATCHDOG);
  if ((events & GNOMON_INTERRUPT_STATUS_RESULT_FULL_MASK) != 0) publish_results(runner);
  restart_watchdog(runner);
  return GNOMON_MAILBOX_FAILURE_IS_NONE;
}

uint32_t job_runner_handle(job_runner* runner, uint32_t events) {
  if ((events & GNOMON_EVENT_DOORBELL) != 0)
    gnomon_set_results_taken(runner->device, mailbox(GNOMON_MAILBOX_RESULTS_TAKEN_OFFSET));
  if (runner->running) {
    const uint32_t failure = follow_job(runner, events);
    if (failure != GNOMON_MAILBOX_FAILURE_IS_NONE) return failure;
  }
  while (!runner->running && runner->next != mailbox(GNOMON_MAILBOX_JOBS_POSTED_OFFSET)) begin_job(runner);
  set_mailbox(GNOMON_MAILBOX_STATE_OFFSET,
              runner->running ? GNOMON_MAILBOX_STATE_IS_WORKING : GNOMON_MAILBOX_STATE_IS_READY);
  return GNOMON_MAILBOX_FAILURE_IS_NONE;
}
