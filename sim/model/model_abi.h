// SPDX-License-Identifier: Apache-2.0
// The C interface between a compiled model (a shared object of the cache) and the rtl engine that loads it.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Raised when anything below changes; it is part of the cache key.
enum { GNOMON_MODEL_ABI = 1 };

// Reset lasts this many cycles; cycle n of the model is at (n + GNOMON_MODEL_RESET_CYCLES) * 10 ns in a
// waveform.
enum { GNOMON_MODEL_RESET_CYCLES = 10 };

// A port is open in a block of 2^block_log2 cycles with chance open_per_256 / 256.
typedef struct GnomonModelGate {
  uint32_t open_per_256;
  uint32_t block_log2;
} GnomonModelGate;

typedef struct GnomonModelStalls {
  GnomonModelGate command;
  GnomonModelGate result;
  uint64_t seed;
} GnomonModelStalls;

enum GnomonModelStop {
  GNOMON_STOP_TAKEN = 0,         // every word is taken
  GNOMON_STOP_IDLE = 1,          // every word is taken and nothing is in progress
  GNOMON_STOP_RESULTS_FULL = 2,  // no room for another result
  GNOMON_STOP_CYCLE_LIMIT = 3,   // max_cycles have passed
  GNOMON_STOP_FAULT = 4          // an assertion or $fatal in the RTL; fault() has its text
};

typedef struct GnomonModelRun {
  const uint64_t* words;  // offered in order, from words_taken on
  uint64_t word_count;
  uint64_t words_taken;     // in and out
  uint64_t* results;        // results go to results[result_count] and on
  uint64_t* result_cycles;  // the cycle at which each of them was taken, since reset
  uint64_t result_capacity;
  uint64_t result_count;  // in and out
  uint64_t max_cycles;    // of this call
  int until_idle;         // 1: GNOMON_STOP_IDLE ends the run, else GNOMON_STOP_TAKEN
} GnomonModelRun;

typedef struct GnomonModelApi {
  uint32_t abi;
  // A model in reset state. Every register and memory bit starts random, from `seed`.
  void* (*create)(uint32_t seed);
  void (*destroy)(void* model);
  void (*set_stalls)(void* model, const GnomonModelStalls* stalls);
  // Asserts reset for GNOMON_MODEL_RESET_CYCLES; cycles count from 0 again.
  void (*reset)(void* model);
  int (*run)(void* model, GnomonModelRun* run);
  // Cycles since the last reset.
  uint64_t (*cycle)(void* model);
  uint64_t (*counter)(void* model, uint32_t index);
  int (*idle)(void* model);
  const char* (*fault)(void* model);
  // Dumps cycles from..to (both included) to an FST file. 0 if the model was built without tracing or the
  // file cannot be written.
  int (*trace_open)(void* model, const char* path, uint64_t from, uint64_t to);
  void (*trace_close)(void* model);
  // 0 if the model was built without coverage.
  int (*write_coverage)(void* model, const char* path);
  // Keeps the whole state; restore goes back to it. Cycles between the two are not written to a waveform.
  // save gives 0 in a model that counts coverage: Verilator offers only one of the two.
  int (*save)(void* model);
  void (*restore)(void* model);
} GnomonModelApi;

// The only symbol a model exports.
const GnomonModelApi* gnomon_model_api(void);

#ifdef __cplusplus
}
#endif
