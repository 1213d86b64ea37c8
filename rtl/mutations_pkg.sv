// SPDX-License-Identifier: Apache-2.0
// Seeded faults: tests build the hardware with one of the GNOMON_MUTATE_* macros defined and show that they notice. Each
// constant is one fault; without a macro all are 0 and vanish. GNOMON_MUTATE_SLB_AT_RUN, GNOMON_MUTATE_PROJECTION_AT_RUN,
// GNOMON_MUTATE_CACHE_AT_RUN and GNOMON_MUTATE_SYSTEM_AT_RUN build in several at once, to be chosen when the simulation
// starts.

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
/* verilator lint_off UNUSEDSIGNAL */  // likewise, of the faults chosen at run time, which are variables
package mutations_pkg;

`ifdef GNOMON_MUTATE_TIES_REPLACE
  localparam bit TIES_REPLACE = 1'b1;  // an update of equal depth writes its entry again
`else
  localparam bit TIES_REPLACE = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_AT_RUN
  bit NO_FORWARDING = $test$plusargs("NO_FORWARDING") != 0;
`elsif GNOMON_MUTATE_CACHE_AT_RUN
  bit NO_FORWARDING = $test$plusargs("NO_FORWARDING") != 0;
`elsif GNOMON_MUTATE_NO_FORWARDING
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
`ifdef GNOMON_MUTATE_SLB_AT_RUN
  bit KEEP_GENERATION = $test$plusargs("KEEP_GENERATION") != 0;
`elsif GNOMON_MUTATE_KEEP_GENERATION
  localparam bit KEEP_GENERATION = 1'b1;  // CLEAR_PLANE does not advance the generation
`else
  localparam bit KEEP_GENERATION = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_AT_RUN
  bit SKIP_BARRIER = $test$plusargs("SKIP_BARRIER") != 0;
`elsif GNOMON_MUTATE_SKIP_BARRIER
  localparam bit SKIP_BARRIER = 1'b1;  // a change of kind does not wait for the drain
`else
  localparam bit SKIP_BARRIER = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SKID_OVERRUN
  localparam bit SKID_OVERRUN = 1'b1;  // a stalled skid buffer takes one word too many
`else
  localparam bit SKID_OVERRUN = 1'b0;
`endif
`ifdef GNOMON_MUTATE_FRAME_FIRST_STATE
  localparam bit FRAME_FIRST_STATE = 1'b1;  // the first state of a voxel counts instead of the last
`else
  localparam bit FRAME_FIRST_STATE = 1'b0;
`endif
`ifdef GNOMON_MUTATE_FRAME_KEEP_AGAIN
  localparam bit FRAME_KEEP_AGAIN = 1'b1;  // a state is kept again while its word waits to be told
`else
  localparam bit FRAME_KEEP_AGAIN = 1'b0;
`endif
`ifdef GNOMON_MUTATE_FRAME_LAYER_ZERO
  localparam bit FRAME_LAYER_ZERO = 1'b1;  // states are kept in layer 0, whatever the command says
`else
  localparam bit FRAME_LAYER_ZERO = 1'b0;
`endif
`ifdef GNOMON_MUTATE_FRAME_SHARE_WORDS
  localparam bit FRAME_SHARE_WORDS = 1'b1;  // states of two lookup commands may share a word
`else
  localparam bit FRAME_SHARE_WORDS = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_AT_RUN
  // The front end of the silhouette-line buffer.
  bit SLB_NO_ADJUST       = $test$plusargs("SLB_NO_ADJUST") != 0;        // rising through a corner, an edge crosses y first
  bit SLB_DRIFT           = $test$plusargs("SLB_DRIFT") != 0;            // the walker drops the remainder of its step
  bit SLB_DEPTH_DRIFT     = $test$plusargs("SLB_DEPTH_DRIFT") != 0;      // the depth of an edge drops its carry
  bit SLB_FORGET_KEPT     = $test$plusargs("SLB_FORGET_KEPT") != 0;      // the vertex of an edge inside one pixel is lost
  bit SLB_FORGET_ASIDE    = $test$plusargs("SLB_FORGET_ASIDE") != 0;     // a loop's last chain has its own depth alone
  bit SLB_EXACT_ALWAYS    = $test$plusargs("SLB_EXACT_ALWAYS") != 0;     // inexact crossings are taken as exact
  bit SLB_LAST_OF_EQUAL   = $test$plusargs("SLB_LAST_OF_EQUAL") != 0;    // of equally good lines the last one is stored
  bit SLB_NO_SPIKES       = $test$plusargs("SLB_NO_SPIKES") != 0;        // a spike has one line
  bit SLB_CORNER_BY_SIDES = $test$plusargs("SLB_CORNER_BY_SIDES") != 0;  // in and out by one side never holds the corner
  bit SLB_COUNT_CLOSE     = $test$plusargs("SLB_COUNT_CLOSE") != 0;      // a loop that ends where it began has no repeat
`else
  localparam bit SLB_NO_ADJUST       = 1'b0;
  localparam bit SLB_DRIFT           = 1'b0;
  localparam bit SLB_DEPTH_DRIFT     = 1'b0;
  localparam bit SLB_FORGET_KEPT     = 1'b0;
  localparam bit SLB_FORGET_ASIDE    = 1'b0;
  localparam bit SLB_EXACT_ALWAYS    = 1'b0;
  localparam bit SLB_LAST_OF_EQUAL   = 1'b0;
  localparam bit SLB_NO_SPIKES       = 1'b0;
  localparam bit SLB_CORNER_BY_SIDES = 1'b0;
  localparam bit SLB_COUNT_CLOSE     = 1'b0;
`endif
`ifdef GNOMON_MUTATE_SLB_AT_RUN
  // The back end of the silhouette-line buffer: one build with all of them, chosen by a plusarg of their name.
  bit SLB_EVICT_EARLIER   = $test$plusargs("SLB_EVICT_EARLIER") != 0;    // of equally far groups the earlier is evicted
  bit SLB_FORGET_CENTRE   = $test$plusargs("SLB_FORGET_CENTRE") != 0;    // an evicted group leaves no answer behind
  bit SLB_KEEP_CORNER     = $test$plusargs("SLB_KEEP_CORNER") != 0;      // a dropped chain still counts as a line
  bit SLB_FIRST_LINE      = $test$plusargs("SLB_FIRST_LINE") != 0;       // a reduced chain always becomes its line A
  bit SLB_WRAP_WINDING    = $test$plusargs("SLB_WRAP_WINDING") != 0;     // sums of winding numbers wrap
  bit SLB_LOSE_CARRY      = $test$plusargs("SLB_LOSE_CARRY") != 0;       // FILL starts every row at 0
  bit SLB_FORGET_PLAIN    = $test$plusargs("SLB_FORGET_PLAIN") != 0;     // FILL says of no line that it is plain
  bit SLB_PLAIN_BEFORE    = $test$plusargs("SLB_PLAIN_BEFORE") != 0;     // plain lines behind others are as those before
  bit SLB_ENTRY_ALONE     = $test$plusargs("SLB_ENTRY_ALONE") != 0;      // an entry's update leaves its line out
  bit SLB_KEEP_LINES      = $test$plusargs("SLB_KEEP_LINES") != 0;       // FILL does not clear has_lines
  bit SLB_COVER_ALL_ROWS  = $test$plusargs("SLB_COVER_ALL_ROWS") != 0;   // COVER trusts rows of earlier objects
  bit SLB_LAST_OBJECT     = $test$plusargs("SLB_LAST_OBJECT") != 0;      // of several covering groups the last is named
  bit SLB_OPEN_HALF_PLANE = $test$plusargs("SLB_OPEN_HALF_PLANE") != 0;  // a point on a line is outside of its inner side
`else
  localparam bit SLB_EVICT_EARLIER   = 1'b0;
  localparam bit SLB_FORGET_CENTRE   = 1'b0;
  localparam bit SLB_KEEP_CORNER     = 1'b0;
  localparam bit SLB_FIRST_LINE      = 1'b0;
  localparam bit SLB_WRAP_WINDING    = 1'b0;
  localparam bit SLB_LOSE_CARRY      = 1'b0;
  localparam bit SLB_FORGET_PLAIN    = 1'b0;
  localparam bit SLB_PLAIN_BEFORE    = 1'b0;
  localparam bit SLB_ENTRY_ALONE     = 1'b0;
  localparam bit SLB_KEEP_LINES      = 1'b0;
  localparam bit SLB_COVER_ALL_ROWS  = 1'b0;
  localparam bit SLB_LAST_OBJECT     = 1'b0;
  localparam bit SLB_OPEN_HALF_PLANE = 1'b0;
`endif
`ifdef GNOMON_MUTATE_PROJECTION_AT_RUN
  // Topology mode.
  bit TOPOLOGY_KEEP_HEAD          = $test$plusargs("TOPOLOGY_KEEP_HEAD") != 0;           // a list keeps its first node as its head
  bit TOPOLOGY_NEAR_LAST          = $test$plusargs("TOPOLOGY_NEAR_LAST") != 0;           // a head's near is that of its last quad
  bit TOPOLOGY_CLIP_SHORT         = $test$plusargs("TOPOLOGY_CLIP_SHORT") != 0;          // a clipped box ends an entry early
  bit TOPOLOGY_NO_EARLY_EXIT      = $test$plusargs("TOPOLOGY_NO_EARLY_EXIT") != 0;       // a hit does not end a walk
  bit TOPOLOGY_LOSE_DROPPED       = $test$plusargs("TOPOLOGY_LOSE_DROPPED") != 0;        // an entry does not know that it lost a quad
  bit TOPOLOGY_OPEN_SIDES         = $test$plusargs("TOPOLOGY_OPEN_SIDES") != 0;          // a beam on a side of a triangle misses it
  bit TOPOLOGY_SORTED_GOES_ON     = $test$plusargs("TOPOLOGY_SORTED_GOES_ON") != 0;      // a quad that is not nearer does not end a sorted walk
  // The perspective projection.
  bit PERSPECTIVE_NO_STEP         = $test$plusargs("PERSPECTIVE_NO_STEP") != 0;          // the reciprocal is its seed
  bit PERSPECTIVE_NEAR_OR_EQUAL   = $test$plusargs("PERSPECTIVE_NEAR_OR_EQUAL") != 0;    // w = W_NEAR is behind
  bit PERSPECTIVE_NO_TURN         = $test$plusargs("PERSPECTIVE_NO_TURN") != 0;          // the offset point is moved at the w of A
  bit PERSPECTIVE_CONE_ALWAYS     = $test$plusargs("PERSPECTIVE_CONE_ALWAYS") != 0;      // the cone counts without its flag
  bit PERSPECTIVE_KEEP_STRADDLING = $test$plusargs("PERSPECTIVE_KEEP_STRADDLING") != 0;  // a quad with some corners behind is linked
  bit PERSPECTIVE_FACE_THE_AXIS   = $test$plusargs("PERSPECTIVE_FACE_THE_AXIS") != 0;    // facing is that of a light along the axis
  bit PERSPECTIVE_NO_CLEARANCE    = $test$plusargs("PERSPECTIVE_NO_CLEARANCE") != 0;     // a beam starts without its clearance
  bit PERSPECTIVE_PLAIN_MAX       = $test$plusargs("PERSPECTIVE_PLAIN_MAX") != 0;        // DELTA_MAX does not follow K/w
`else
  localparam bit TOPOLOGY_KEEP_HEAD          = 1'b0;
  localparam bit TOPOLOGY_NEAR_LAST          = 1'b0;
  localparam bit TOPOLOGY_CLIP_SHORT         = 1'b0;
  localparam bit TOPOLOGY_NO_EARLY_EXIT      = 1'b0;
  localparam bit TOPOLOGY_LOSE_DROPPED       = 1'b0;
  localparam bit TOPOLOGY_OPEN_SIDES         = 1'b0;
  localparam bit TOPOLOGY_SORTED_GOES_ON     = 1'b0;
  localparam bit PERSPECTIVE_NO_STEP         = 1'b0;
  localparam bit PERSPECTIVE_NEAR_OR_EQUAL   = 1'b0;
  localparam bit PERSPECTIVE_NO_TURN         = 1'b0;
  localparam bit PERSPECTIVE_CONE_ALWAYS     = 1'b0;
  localparam bit PERSPECTIVE_KEEP_STRADDLING = 1'b0;
  localparam bit PERSPECTIVE_FACE_THE_AXIS   = 1'b0;
  localparam bit PERSPECTIVE_NO_CLEARANCE    = 1'b0;
  localparam bit PERSPECTIVE_PLAIN_MAX       = 1'b0;
`endif
`ifdef GNOMON_MUTATE_CACHE_AT_RUN
  // The caches before planes and lists in memory.
  bit CACHE_LOSE_WRITE_BACK = $test$plusargs("CACHE_LOSE_WRITE_BACK") != 0;  // a written line is dropped when its slot is wanted
  bit CACHE_FETCH_EARLY     = $test$plusargs("CACHE_FETCH_EARLY") != 0;      // a line is fetched while it is on its way out
  bit CACHE_KEEP_TOUCHED    = $test$plusargs("CACHE_KEEP_TOUCHED") != 0;     // a clear forgets tags, not what memory holds
`else
  localparam bit CACHE_LOSE_WRITE_BACK = 1'b0;
  localparam bit CACHE_FETCH_EARLY     = 1'b0;
  localparam bit CACHE_KEEP_TOUCHED    = 1'b0;
`endif

`ifdef GNOMON_MUTATE_SYSTEM_AT_RUN
  // What is around the core.
  bit AXI_WITHDRAW        = $test$plusargs("AXI_WITHDRAW") != 0;         // a read's address is not offered until it is taken
  bit AXI_CHANGE_ADDRESS  = $test$plusargs("AXI_CHANGE_ADDRESS") != 0;   // a write's address changes while it waits
  bit AXI_LAST_EARLY      = $test$plusargs("AXI_LAST_EARLY") != 0;       // the beat before the last says that it is the last
  bit AXI_CROSS_PAGES     = $test$plusargs("AXI_CROSS_PAGES") != 0;      // bursts of commands cross 4 KiB
  bit AXI_FIXED_BURST     = $test$plusargs("AXI_FIXED_BURST") != 0;      // bursts say that their address stays
  bit AXI_IGNORE_ERRORS   = $test$plusargs("AXI_IGNORE_ERRORS") != 0;    // error answers are taken as good ones
  bit AXI_FORGET_EPOCH    = $test$plusargs("AXI_FORGET_EPOCH") != 0;     // late answers are taken as new ones
  bit AXI_NO_TIMEOUT      = $test$plusargs("AXI_NO_TIMEOUT") != 0;       // a missing answer is waited for for ever
  bit RESULTS_COUNT_EARLY = $test$plusargs("RESULTS_COUNT_EARLY") != 0;  // results count when their write begins
`else
  localparam bit AXI_WITHDRAW        = 1'b0;
  localparam bit AXI_CHANGE_ADDRESS  = 1'b0;
  localparam bit AXI_LAST_EARLY      = 1'b0;
  localparam bit AXI_CROSS_PAGES     = 1'b0;
  localparam bit AXI_FIXED_BURST     = 1'b0;
  localparam bit AXI_IGNORE_ERRORS   = 1'b0;
  localparam bit AXI_FORGET_EPOCH    = 1'b0;
  localparam bit AXI_NO_TIMEOUT      = 1'b0;
  localparam bit RESULTS_COUNT_EARLY = 1'b0;
`endif

endpackage
/* verilator lint_on UNUSEDSIGNAL */
/* verilator lint_on UNUSEDPARAM */
