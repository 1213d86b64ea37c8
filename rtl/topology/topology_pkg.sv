// SPDX-License-Identifier: Apache-2.0
// Result words, events and record widths of topology mode (docs/vpu-topology.md).

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package topology_pkg;

  localparam logic [7:0] RESULT_TOPOLOGY_STATE = 8'h14;
  localparam logic [7:0] RESULT_LIST_HEAD      = 8'h15;

  localparam int unsigned NUMBER_BITS = 24;  // number of a quad
  localparam int unsigned COUNT_BITS  = 12;  // nodes visited, quads tested, in a result

  typedef struct packed {
    logic [7:0]             code;
    logic [1:0]             state;
    logic                   facing_away;
    logic                   off_plane;
    logic                   uncertain;
    logic                   hit;
    logic                   fallback;
    logic                   unreached;  // with fallback: behind the light; without: outside its cone
    logic [NUMBER_BITS-1:0] quad;
    logic [COUNT_BITS-1:0]  visited;
    logic [COUNT_BITS-1:0]  tested;
  } topology_result_t;

  typedef struct packed {
    logic [7:0]  code;
    logic [23:0] index;
    logic        present;
    logic        linked;
    logic        dropped;
    logic [4:0]  zero;
    logic [23:0] near_depth;
  } list_head_result_t;

  // What a walk came to.
  typedef struct packed {
    logic                   hit;
    logic [NUMBER_BITS-1:0] quad;
    logic [COUNT_BITS-1:0]  visited;
    logic [COUNT_BITS-1:0]  tested;
  } walk_t;

  // One bit an event counter, each at most one a cycle, in the order of the page.
  typedef struct packed {
    logic quad_put;
    logic quad_off_plane;
    logic quad_too_large;
    logic quad_saturated;
    logic node_linked;
    logic node_dropped;
    logic resolved;
    logic facing_away;
    logic off_plane;
    logic uncertain;
    logic hit;
    logic fallback;
    logic shadow;
    logic node_visited;
    logic quad_tested;
  } topology_events_t;
  localparam int unsigned COUNTER_COUNT = 15;

  // List head as its memory keeps it behind the generation: {dropped, linked, near, head}.
  function automatic int unsigned head_bits(int unsigned d, int unsigned nodes_log2);
    head_bits = 2 + d + nodes_log2;
  endfunction
  // What travels with the read of a head: {unreached, behind (both only in hardware with the perspective projection),
  // facing away, off the plane, sorted, limit, v, u}.
  function automatic int unsigned head_tag_bits(bit en_perspective, int unsigned d, int unsigned place);
    head_tag_bits = (en_perspective ? 5 : 3) + d + 2 * place;
  endfunction
  // {last, next, far, quad}
  function automatic int unsigned node_bits(int unsigned d, int unsigned nodes_log2, int unsigned quads_log2);
    node_bits = 1 + nodes_log2 + d + quads_log2;
  endfunction
  // {v_base, u_base, dv and du of corners 3..0}. Of a base the low `span_log2` bits are kept: a beam lies in the quad's
  // box, so that they tell how far it is from the base.
  function automatic int unsigned record_bits(int unsigned sub_bits, int unsigned span_log2);
    record_bits = 2 * span_log2 + 8 * (span_log2 + sub_bits);
  endfunction

endpackage
/* verilator lint_on UNUSEDPARAM */
