// SPDX-License-Identifier: Apache-2.0
// Widths, words and events of the cubic frame buffer (docs/frame-buffer.md).

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package frame_pkg;

  localparam int unsigned STATE_BITS  = 2;
  localparam int unsigned PLACE_BITS  = 6;    // of a state in its brick of 4 x 4 x 4 voxels
  localparam int unsigned BRICK_BITS  = 128;
  localparam int unsigned LAYER_BITS  = 4;    // field of a command's arg
  localparam int unsigned WORD_STATES = 24;   // at most, in a FRAME_STATES word
  localparam int unsigned LAST_STATES = 16;   // in the third word of a brick

  localparam logic [1:0] STATE_EMPTY = 2'd0;

  // Of a brick's index: layer, then z, y and x in bricks.
  function automatic int unsigned index_bits(int unsigned voxel_bits, int unsigned layers_log2);
    index_bits = 3 * (voxel_bits - 2) + layers_log2;
  endfunction

  typedef struct packed {
    logic [PLACE_BITS-1:0] place;
    logic [STATE_BITS-1:0] state;
  } operand_t;
  localparam int unsigned OPERAND_BITS = 8;

  // What travels with the read of a lookup.
  typedef struct packed {
    logic                  last;   // of its command
    logic                  brick;  // the whole of it is asked for
    logic [PLACE_BITS-1:0] place;
  } tag_t;
  localparam int unsigned TAG_BITS = 8;

  // Bit 0 is the last field.
  typedef struct packed {
    logic [7:0]  code;
    logic [7:0]  count;
    logic [47:0] states;  // the first in the low bits
  } frame_states_t;

  // Increments of the event counters in a cycle, in the order of the page.
  typedef struct packed {
    logic kept;
    logic overwritten;
    logic lookup;
    logic lookup_empty;
    logic brick;
  } frame_events_t;
  localparam int unsigned COUNTER_COUNT = 5;

endpackage
/* verilator lint_on UNUSEDPARAM */
