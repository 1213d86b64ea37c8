// SPDX-License-Identifier: Apache-2.0
// The hardware as software sees it (docs/system.md): identity, rings, interrupts, errors, reset, counters.
#ifndef GNOMON_DRIVER_H
#define GNOMON_DRIVER_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
  GNOMON_OK,
  GNOMON_NO_HARDWARE,    // another identity
  GNOMON_WRONG_VERSION,  // another major version
  GNOMON_NO_RINGS,       // built without
  GNOMON_BAD_RING,       // size or alignment
  GNOMON_RING_FULL,
  GNOMON_NO_RESET,  // it does not end
} gnomon_result;

/// What this build can do; widths are the parameters of the same names.
typedef struct {
  uint32_t version, features;
  uint8_t voxel_bits, normal_bits, plane_log2, depth_bits, slb_plane_log2, cache_log2;
} gnomon_capabilities;

/// A ring of 2^log2 places at an address aligned to its bytes.
typedef struct {
  uint32_t address, log2;
} gnomon_ring;

typedef struct {
  uintptr_t base;
  gnomon_ring commands, results;
  uint32_t planes;        // memory for planes and lists
  uint32_t command_head;  // descriptors put in since the rings were set up
} gnomon_device;

enum { GNOMON_DESCRIPTOR_LAST = 1, GNOMON_DESCRIPTOR_INTERRUPT = 2, GNOMON_DESCRIPTOR_COMPLETE = 0x8000 };

/// A descriptor, as it lies in the command ring.
typedef struct {
  uint32_t address_low, address_high;
  uint32_t words;
  uint16_t job, flags;
} gnomon_descriptor;

/// The same place when its job is complete.
typedef struct {
  uint32_t results;  // the result ring's head
  uint32_t flags;    // sticky flags that the job has raised
  uint32_t errors;   // error results
  uint16_t job, state;
} gnomon_completion;

/// Whether there is hardware that this driver knows, with rings. Touches nothing but reads.
gnomon_result gnomon_probe(gnomon_device* device, uintptr_t base, gnomon_capabilities* capabilities);

/// Sets the rings up, the command ring empty, the result ring from `results_head` on, of which
/// `results_taken` are no longer needed; then enables the hardware, which must be idle (after power-up or
/// reset), and its interrupts.
gnomon_result gnomon_start(gnomon_device* device, uint32_t results_head, uint32_t results_taken);

/// Puts a whole job of one descriptor into the command ring; `place` is where its completion will be.
gnomon_result gnomon_submit(gnomon_device* device, uint32_t address, uint32_t words, uint16_t job,
                            uint32_t* place);

/// Whether the job of this place is complete, and how it went.
bool gnomon_complete(const gnomon_device* device, uint32_t place, gnomon_completion* completion);

/// Interrupt status bits, and clears those it gives.
uint32_t gnomon_take_interrupts(const gnomon_device* device);

uint32_t gnomon_results_head(const gnomon_device* device);
void gnomon_set_results_taken(const gnomon_device* device, uint32_t taken);

/// ERROR_STATUS if the hardware has stopped, else 0.
uint32_t gnomon_error(const gnomon_device* device);

/// As after power-up; the rings are to be started again.
gnomon_result gnomon_reset(gnomon_device* device);

/// All counters of one moment; then one of them.
void gnomon_take_snapshot(const gnomon_device* device);
uint64_t gnomon_counter(const gnomon_device* device, uint32_t index);

#ifdef __cplusplus
}
#endif

#endif
