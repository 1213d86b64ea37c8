// SPDX-License-Identifier: Apache-2.0
// Register accesses in the order that docs/system.md asks for.
#include "firmware/driver/gnomon_driver.h"

#include <stddef.h>

#include "firmware/driver/gnomon_registers.h"
#include "firmware/driver/platform.h"

enum { kDescriptorBytes = 16, kResultBytes = 8 };
enum { kMinCommandLog2 = 1, kMaxCommandLog2 = 16, kMinResultLog2 = 6, kMaxResultLog2 = 28 };
// A reset waits for the bus at most AXI_TIMEOUT cycles, 65,536 after power-up; a poll takes more than eight.
enum { kResetPolls = 20000 };

static uint32_t get(const gnomon_device* device, uint32_t offset) {
  return platform_read(device->base + offset);
}

static void set(const gnomon_device* device, uint32_t offset, uint32_t value) {
  platform_write(device->base + offset, value);
}

static uint8_t byte_of(uint32_t word, uint32_t shift) {
  return (uint8_t)(word >> shift);
}

static void read_capabilities(const gnomon_device* device, gnomon_capabilities* capabilities) {
  const uint32_t voxel = get(device, GNOMON_WIDTHS_VOXEL_OFFSET);
  const uint32_t plane = get(device, GNOMON_WIDTHS_PLANE_OFFSET);
  const uint32_t slb = get(device, GNOMON_WIDTHS_SLB_OFFSET);
  const uint32_t memory = get(device, GNOMON_WIDTHS_MEMORY_OFFSET);
  capabilities->version = get(device, GNOMON_VERSION_OFFSET);
  capabilities->features = get(device, GNOMON_FEATURES_OFFSET);
  capabilities->voxel_bits = byte_of(voxel, GNOMON_WIDTHS_VOXEL_VOXEL_BITS_SHIFT);
  capabilities->normal_bits = byte_of(voxel, GNOMON_WIDTHS_VOXEL_NORMAL_BITS_SHIFT);
  capabilities->plane_log2 = byte_of(plane, GNOMON_WIDTHS_PLANE_PLANE_LOG2_SHIFT);
  capabilities->depth_bits = byte_of(plane, GNOMON_WIDTHS_PLANE_DEPTH_BITS_SHIFT);
  capabilities->slb_plane_log2 = byte_of(slb, GNOMON_WIDTHS_SLB_SLB_PLANE_LOG2_SHIFT);
  capabilities->cache_log2 = byte_of(memory, GNOMON_WIDTHS_MEMORY_CACHE_LOG2_SHIFT);
}

gnomon_result gnomon_probe(gnomon_device* device, uintptr_t base, gnomon_capabilities* capabilities) {
  device->base = base;
  if (get(device, GNOMON_ID_OFFSET) != GNOMON_ID_RESET) return GNOMON_NO_HARDWARE;
  const uint32_t major_differs =
      (get(device, GNOMON_VERSION_OFFSET) ^ GNOMON_VERSION_RESET) & GNOMON_VERSION_MAJOR_MASK;
  if (major_differs != 0) return GNOMON_WRONG_VERSION;
  read_capabilities(device, capabilities);
  return (capabilities->features & GNOMON_FEATURES_RINGS_MASK) != 0 ? GNOMON_OK : GNOMON_NO_RINGS;
}

static bool is_ring(gnomon_ring ring, uint32_t place_bytes, uint32_t min_log2, uint32_t max_log2) {
  if (ring.log2 < min_log2 || ring.log2 > max_log2) return false;
  return (ring.address & ((place_bytes << ring.log2) - 1U)) == 0;
}

gnomon_result gnomon_start(gnomon_device* device, uint32_t results_head, uint32_t results_taken) {
  if (!is_ring(device->commands, kDescriptorBytes, kMinCommandLog2, kMaxCommandLog2) ||
      !is_ring(device->results, kResultBytes, kMinResultLog2, kMaxResultLog2))
    return GNOMON_BAD_RING;
  device->command_head = 0;
  set(device, GNOMON_CONTROL_OFFSET, 0);
  set(device, GNOMON_PLANE_BASE_LOW_OFFSET, device->planes);
  set(device, GNOMON_PLANE_BASE_HIGH_OFFSET, 0);
  set(device, GNOMON_COMMAND_BASE_LOW_OFFSET, device->commands.address);
  set(device, GNOMON_COMMAND_BASE_HIGH_OFFSET, 0);
  set(device, GNOMON_COMMAND_SIZE_OFFSET, device->commands.log2);
  set(device, GNOMON_COMMAND_HEAD_OFFSET, 0);
  set(device, GNOMON_COMMAND_TAIL_OFFSET, 0);
  set(device, GNOMON_RESULT_BASE_LOW_OFFSET, device->results.address);
  set(device, GNOMON_RESULT_BASE_HIGH_OFFSET, 0);
  set(device, GNOMON_RESULT_SIZE_OFFSET, device->results.log2);
  set(device, GNOMON_RESULT_HEAD_OFFSET, results_head);
  set(device, GNOMON_RESULT_TAIL_OFFSET, results_taken);
  set(device, GNOMON_INTERRUPT_ENABLE_OFFSET,
      GNOMON_INTERRUPT_ENABLE_JOB_DONE_MASK | GNOMON_INTERRUPT_ENABLE_RESULT_FULL_MASK |
          GNOMON_INTERRUPT_ENABLE_ERROR_MASK);
  set(device, GNOMON_CONTROL_OFFSET, GNOMON_CONTROL_ENABLE_MASK);
  return GNOMON_OK;
}

static volatile gnomon_descriptor* place_at(const gnomon_device* device, uint32_t place) {
  const uint32_t index = place & ((1U << device->commands.log2) - 1U);
  return platform_memory(device->commands.address + index * kDescriptorBytes);
}

gnomon_result gnomon_submit(gnomon_device* device, uint32_t address, uint32_t words, uint16_t job,
                            uint32_t* place) {
  const uint32_t used = device->command_head - get(device, GNOMON_COMMAND_TAIL_OFFSET);
  if (used >= 1U << device->commands.log2) return GNOMON_RING_FULL;
  volatile gnomon_descriptor* const descriptor = place_at(device, device->command_head);
  descriptor->address_low = address;
  descriptor->address_high = 0;
  descriptor->words = words;
  descriptor->job = job;
  descriptor->flags = GNOMON_DESCRIPTOR_LAST | GNOMON_DESCRIPTOR_INTERRUPT;
  *place = device->command_head++;
  platform_barrier();
  set(device, GNOMON_COMMAND_HEAD_OFFSET, device->command_head);
  return GNOMON_OK;
}

bool gnomon_complete(const gnomon_device* device, uint32_t place, gnomon_completion* completion) {
  const volatile gnomon_completion* const written =
      (const volatile gnomon_completion*)place_at(device, place);
  completion->state = written->state;
  if ((completion->state & GNOMON_DESCRIPTOR_COMPLETE) == 0) return false;
  platform_barrier();
  completion->results = written->results;
  completion->flags = written->flags;
  completion->errors = written->errors;
  completion->job = written->job;
  return true;
}

uint32_t gnomon_take_interrupts(const gnomon_device* device) {
  const uint32_t status = get(device, GNOMON_INTERRUPT_STATUS_OFFSET);
  set(device, GNOMON_INTERRUPT_STATUS_OFFSET, status);
  return status;
}

uint32_t gnomon_results_head(const gnomon_device* device) {
  return get(device, GNOMON_RESULT_HEAD_OFFSET);
}

void gnomon_set_results_taken(const gnomon_device* device, uint32_t taken) {
  set(device, GNOMON_RESULT_TAIL_OFFSET, taken);
}

uint32_t gnomon_error(const gnomon_device* device) {
  if ((get(device, GNOMON_STATUS_OFFSET) & GNOMON_STATUS_STOPPED_MASK) == 0) return 0;
  return get(device, GNOMON_ERROR_STATUS_OFFSET);
}

gnomon_result gnomon_reset(gnomon_device* device) {
  set(device, GNOMON_RESET_OFFSET, GNOMON_RESET_SOFT_RESET_MASK);
  for (int polls = 0; polls < kResetPolls; ++polls)
    if ((get(device, GNOMON_RESET_OFFSET) & GNOMON_RESET_SOFT_RESET_MASK) == 0) return GNOMON_OK;
  return GNOMON_NO_RESET;
}

void gnomon_take_snapshot(const gnomon_device* device) {
  set(device, GNOMON_SNAPSHOT_OFFSET, GNOMON_SNAPSHOT_TAKE_MASK);
}

uint64_t gnomon_counter(const gnomon_device* device, uint32_t index) {
  const uint32_t low = get(device, GNOMON_COUNTER_LOW_OFFSET + index * GNOMON_COUNTER_LOW_STRIDE);
  const uint32_t high = get(device, GNOMON_COUNTER_HIGH_OFFSET + index * GNOMON_COUNTER_HIGH_STRIDE);
  return (uint64_t)high << 32U | low;
}
