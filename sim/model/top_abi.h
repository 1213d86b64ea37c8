// SPDX-License-Identifier: Apache-2.0
// The C interface between a compiled model of gnomon_top (a shared object of the cache) and whoever surrounds
// it: registers, memory and an interrupt line.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Raised when anything below changes; it is part of the cache key.
enum { GNOMON_TOP_ABI = 1 };

// Reset lasts this many cycles; cycle n of the model is at (n + GNOMON_TOP_RESET_CYCLES) * 10 ns in a
// waveform.
enum { GNOMON_TOP_RESET_CYCLES = 10 };

// A read burst of commands, the longest; all others stay within a line.
enum { GNOMON_TOP_BURST_BYTES = 512, GNOMON_TOP_LINE_BYTES = 64 };

// What has happened when run() comes back: any of these together.
enum GnomonTopEvent {
  GNOMON_TOP_READ = 1,       // the master has begun a read; take_read() has it
  GNOMON_TOP_WRITE = 2,      // all of a write has been taken; take_write() has it
  GNOMON_TOP_ACCESS = 4,     // the access to a register is answered
  GNOMON_TOP_INTERRUPT = 8,  // the interrupt line has changed
  GNOMON_TOP_FAULT = 16      // an assertion or $fatal in the RTL; fault() has its text
};

typedef struct GnomonTopRead {
  uint64_t cycle;    // since reset, at which its address was taken
  uint64_t start;    // the address asked for
  uint64_t address;  // of the first beat, whole
  uint32_t id;
  uint32_t beats;
  uint32_t bytes;  // of all beats
} GnomonTopRead;

typedef struct GnomonTopWrite {
  uint64_t cycle;    // since reset, at which its last beat was taken
  uint64_t address;  // of data[0]
  uint32_t id;
  uint32_t bytes;
  uint8_t data[GNOMON_TOP_LINE_BYTES];
  uint64_t strobe;  // a bit a byte
} GnomonTopWrite;

typedef struct GnomonTopApi {
  uint32_t abi;
  // A model in reset state. Every register and memory bit starts random, from `seed`.
  void* (*create)(uint32_t seed);
  void (*destroy)(void* model);
  // Until cycle `until` is reached (0) or something has happened (a set of GnomonTopEvent).
  int (*run)(void* model, uint64_t until);
  // Cycles since reset.
  uint64_t (*cycle)(const void* model);
  int (*interrupt)(const void* model);
  const char* (*fault)(void* model);
  // Begins an access to a register; one at a time.
  void (*begin_access)(void* model, int is_write, uint32_t offset, uint32_t data);
  // Its answer: 0 OKAY, 2 SLVERR, and in `data` what was read.
  int (*end_access)(void* model, uint32_t* data);
  // 0 if there is none.
  int (*take_read)(void* model, GnomonTopRead* read);
  int (*take_write)(void* model, GnomonTopWrite* write);
  // Answers, given in this order on each channel, not before `cycle`; `data` has the bytes of the read.
  void (*answer_read)(void* model, const GnomonTopRead* read, uint64_t cycle, const uint8_t* data,
                      int response);
  void (*answer_write)(void* model, const GnomonTopWrite* write, uint64_t cycle, int response);
  // Dumps cycles from..to (both included) to an FST file. 0 if the model was built without tracing or the
  // file cannot be written.
  int (*trace_open)(void* model, const char* path, uint64_t from, uint64_t to);
  void (*trace_close)(void* model);
} GnomonTopApi;

// The only symbol a model of gnomon_top exports.
const GnomonTopApi* gnomon_top_api(void);

#ifdef __cplusplus
}
#endif
