// SPDX-License-Identifier: Apache-2.0
// Seeded faults: tests build the hardware with one of the GNOMON_MUTATE_* macros defined and show that they notice. Each
// constant is used at one place; without a macro all are 0 and vanish.

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package mutations_pkg;

`ifdef GNOMON_MUTATE_TIES_REPLACE
  localparam bit TIES_REPLACE = 1'b1;  // an update of equal depth writes its entry again
`else
  localparam bit TIES_REPLACE = 1'b0;
`endif
`ifdef GNOMON_MUTATE_NO_FORWARDING
  localparam bit NO_FORWARDING = 1'b1;  // an update does not see the writes that are still on their way
`else
  localparam bit NO_FORWARDING = 1'b0;
`endif
`ifdef GNOMON_MUTATE_ROUND_DEPTH
  localparam bit ROUND_DEPTH = 1'b1;  // depth codes are rounded to nearest instead of down
`else
  localparam bit ROUND_DEPTH = 1'b0;
`endif
`ifdef GNOMON_MUTATE_MARGIN_OR_EQUAL
  localparam bit MARGIN_OR_EQUAL = 1'b1;  // the margin test compares with >= instead of >
`else
  localparam bit MARGIN_OR_EQUAL = 1'b0;
`endif
`ifdef GNOMON_MUTATE_LOSE_STICKY
  localparam bit LOSE_STICKY = 1'b1;  // a voxel off the plane does not raise its sticky flag
`else
  localparam bit LOSE_STICKY = 1'b0;
`endif
`ifdef GNOMON_MUTATE_KEEP_GENERATION
  localparam bit KEEP_GENERATION = 1'b1;  // CLEAR_PLANE does not advance the generation
`else
  localparam bit KEEP_GENERATION = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SKIP_BARRIER
  localparam bit SKIP_BARRIER = 1'b1;  // a change of kind does not wait for the drain
`else
  localparam bit SKIP_BARRIER = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SKID_OVERRUN
  localparam bit SKID_OVERRUN = 1'b1;  // a stalled skid buffer takes one word too many
`else
  localparam bit SKID_OVERRUN = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_NO_ADJUST
  localparam bit SLB_NO_ADJUST = 1'b1;  // an edge through a pixel corner crosses y first also where it rises to the right
`else
  localparam bit SLB_NO_ADJUST = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_LAST_OF_EQUAL
  localparam bit SLB_LAST_OF_EQUAL = 1'b1;  // of equally good lines the last one is stored
`else
  localparam bit SLB_LAST_OF_EQUAL = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_EVICT_EARLIER
  localparam bit SLB_EVICT_EARLIER = 1'b1;  // of equally far groups the earlier is evicted
`else
  localparam bit SLB_EVICT_EARLIER = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_OPEN_HALF_PLANE
  localparam bit SLB_OPEN_HALF_PLANE = 1'b1;  // a point on a line is outside of its inner side
`else
  localparam bit SLB_OPEN_HALF_PLANE = 1'b0;
`endif

endpackage
/* verilator lint_on UNUSEDPARAM */
