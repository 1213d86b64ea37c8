// SPDX-License-Identifier: Apache-2.0
// Words of the command and result streams, and the widths that follow from the parameters: the one source in
// SystemVerilog, written from docs/command-stream.md and docs/vpu.md and compared with the C++ codec by tests/rtl.

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package gnomon_pkg;

  localparam int unsigned WORD_BITS = 64;

  // ---- Commands ----
  typedef struct packed {
    logic [7:0]  op;
    logic [7:0]  flags;
    logic [15:0] count;
    logic [31:0] arg;
  } header_t;

  localparam logic [7:0] OP_NOP              = 8'h00;
  localparam logic [7:0] OP_SET_REGISTERS    = 8'h01;
  localparam logic [7:0] OP_CLEAR_PLANE      = 8'h02;
  localparam logic [7:0] OP_FENCE            = 8'h03;
  localparam logic [7:0] OP_READ_PLANE       = 8'h04;
  localparam logic [7:0] OP_PROJECT_VOXELS   = 8'h10;
  localparam logic [7:0] OP_RESOLVE_VOXELS   = 8'h11;
  localparam logic [7:0] OP_CLEAR_LISTS      = 8'h12;
  localparam logic [7:0] OP_PUT_QUADS        = 8'h13;
  localparam logic [7:0] OP_RESOLVE_TOPOLOGY = 8'h14;
  localparam logic [7:0] OP_READ_LISTS       = 8'h15;
  localparam logic [7:0] OP_SLB_CLEAR        = 8'h20;
  localparam logic [7:0] OP_BEGIN_OBJECT     = 8'h21;
  localparam logic [7:0] OP_LOOP             = 8'h22;
  localparam logic [7:0] OP_FILL             = 8'h23;
  localparam logic [7:0] OP_COVER            = 8'h24;
  localparam logic [7:0] OP_END_OBJECT       = 8'h25;
  localparam logic [7:0] OP_QUERY            = 8'h26;
  localparam logic [7:0] OP_READ_ENTRIES     = 8'h27;
  localparam logic [7:0] OP_CLEAR_FRAME      = 8'h30;
  localparam logic [7:0] OP_LOOKUP_FRAME     = 8'h31;

  localparam logic [7:0] FENCE_CLEAR_STICKY = 8'h01;
  localparam logic [7:0] RESOLVE_TWO_SIDED  = 8'h01;
  localparam logic [7:0] TOPOLOGY_TWO_SIDED = 8'h01;
  localparam logic [7:0] TOPOLOGY_SORTED    = 8'h02;
  localparam logic [7:0] BEGIN_FLAT         = 8'h01;
  localparam logic [7:0] LOOP_MORE          = 8'h01;
  localparam logic [7:0] LOOKUP_BRICK       = 8'h01;
  localparam logic [7:0] RESOLVE_KEEP       = 8'h40;  // both resolve commands
  localparam logic [7:0] RESOLVE_QUIET      = 8'h80;

  // Commands of topology mode: 0x12..0x15.
  function automatic bit is_topology_op(logic [7:0] op);
    is_topology_op = op >= OP_CLEAR_LISTS && op <= OP_READ_LISTS;
  endfunction

  // Commands of the silhouette-line buffer: 0x20..0x27.
  function automatic bit is_slb_op(logic [7:0] op);
    is_slb_op = op >= OP_SLB_CLEAR && op <= OP_READ_ENTRIES;
  endfunction

  // Commands of the frame buffer: 0x30 and 0x31.
  function automatic bit is_frame_op(logic [7:0] op);
    is_frame_op = op == OP_CLEAR_FRAME || op == OP_LOOKUP_FRAME;
  endfunction

  // Commands whose states the frame buffer can keep.
  function automatic bit is_resolve_op(logic [7:0] op);
    is_resolve_op = op == OP_RESOLVE_VOXELS || op == OP_RESOLVE_TOPOLOGY;
  endfunction

  // ---- Registers ----
  localparam int unsigned REGISTER_COUNT      = 32;
  localparam int unsigned PLAIN_REGISTERS     = 18;  // of hardware without EN_PERSPECTIVE
  localparam int unsigned REGISTER_INDEX_BITS = 5;
  localparam logic [4:0] REG_MATRIX_UX      = 5'd0;
  localparam logic [4:0] REG_MATRIX_UY      = 5'd1;
  localparam logic [4:0] REG_MATRIX_UZ      = 5'd2;
  localparam logic [4:0] REG_MATRIX_U1      = 5'd3;
  localparam logic [4:0] REG_MATRIX_VX      = 5'd4;
  localparam logic [4:0] REG_MATRIX_VY      = 5'd5;
  localparam logic [4:0] REG_MATRIX_VZ      = 5'd6;
  localparam logic [4:0] REG_MATRIX_V1      = 5'd7;
  localparam logic [4:0] REG_MATRIX_DX      = 5'd8;
  localparam logic [4:0] REG_MATRIX_DY      = 5'd9;
  localparam logic [4:0] REG_MATRIX_DZ      = 5'd10;
  localparam logic [4:0] REG_MATRIX_D1      = 5'd11;
  localparam logic [4:0] REG_OFFSET_FACTOR  = 5'd12;
  localparam logic [4:0] REG_FACING_SHIFT   = 5'd13;
  localparam logic [4:0] REG_TILT_SHIFT     = 5'd14;
  localparam logic [4:0] REG_DELTA_SHIFT    = 5'd15;
  localparam logic [4:0] REG_MARGIN_SQUARED = 5'd16;
  localparam logic [4:0] REG_DELTA_MAX      = 5'd17;
  localparam logic [4:0] REG_PROJECTION     = 5'd18;
  localparam logic [4:0] REG_MATRIX_WX      = 5'd19;
  localparam logic [4:0] REG_MATRIX_WY      = 5'd20;
  localparam logic [4:0] REG_MATRIX_WZ      = 5'd21;
  localparam logic [4:0] REG_MATRIX_W1      = 5'd22;
  localparam logic [4:0] REG_W_NEAR         = 5'd23;
  localparam logic [4:0] REG_CENTRE_U       = 5'd24;
  localparam logic [4:0] REG_CENTRE_V       = 5'd25;
  localparam logic [4:0] REG_KEY_LIMIT      = 5'd26;
  localparam logic [4:0] REG_KEY_SCALE      = 5'd27;
  localparam logic [4:0] REG_LIGHT_X        = 5'd28;
  localparam logic [4:0] REG_LIGHT_Y        = 5'd29;
  localparam logic [4:0] REG_LIGHT_Z        = 5'd30;
  localparam logic [4:0] REG_CONE_SQUARED   = 5'd31;

  // ---- Results ----
  localparam logic [7:0] RESULT_FENCE       = 8'h03;
  localparam logic [7:0] RESULT_PLANE_ENTRY = 8'h04;
  localparam logic [7:0] RESULT_VOXEL_STATE = 8'h11;
  localparam logic [7:0] RESULT_SLB_ANSWER  = 8'h26;
  localparam logic [7:0] RESULT_SLB_ENTRY   = 8'h27;
  localparam logic [7:0] RESULT_FRAME_STATES = 8'h31;
  localparam logic [7:0] RESULT_ERROR       = 8'hFF;

  localparam logic [7:0] ERROR_NONE           = 8'd0;
  localparam logic [7:0] ERROR_UNKNOWN_OP     = 8'd1;
  localparam logic [7:0] ERROR_FEATURE_ABSENT = 8'd2;
  localparam logic [7:0] ERROR_BAD_REGISTER   = 8'd3;
  localparam logic [7:0] ERROR_BAD_ARGUMENT   = 8'd4;
  localparam logic [7:0] ERROR_RESERVED_FLAG  = 8'd5;
  localparam logic [7:0] ERROR_BAD_SEQUENCE   = 8'd6;

  localparam int unsigned STATE_LSB   = 54;  // of the state in VOXEL_STATE and TOPOLOGY_STATE
  localparam logic [1:0] STATE_LIT    = 2'd1;
  localparam logic [1:0] STATE_SHADOW = 2'd2;

  localparam int unsigned DEPTH_FIELD_BITS = 24;  // a depth code in words, tags and the plane, whatever DEPTH_BITS
  localparam int unsigned INDEX_FIELD_BITS = 24;  // an entry index in words

  // Bit 0 is the last field.
  typedef struct packed {
    logic       winding_saturated;
    logic       object_overflow;
    logic       line_overflow;
    logic [1:0] zero;
    logic       behind_light;
    logic       quad_off_plane;
    logic       list_overflow;
    logic       depth_saturated;
    logic       off_plane;
    logic       error_seen;
  } sticky_t;
  localparam int unsigned STICKY_BITS = 11;

  typedef struct packed {
    logic [7:0]  code;
    logic [12:0] zero;
    sticky_t     sticky;
    logic [31:0] tag;
  } fence_result_t;

  typedef struct packed {
    logic [7:0]  code;
    logic [23:0] index;
    logic        present;
    logic [6:0]  zero;
    logic [23:0] depth;
  } plane_entry_result_t;

  typedef struct packed {
    logic [7:0]  code;
    logic [1:0]  state;
    logic        facing_away;
    logic        off_plane;
    logic        uncertain;
    logic        offset_empty;
    logic        beyond_max;
    logic        unreached;  // with beyond_max: behind the light; without: outside its cone
    logic [23:0] nearest;
    logic [23:0] delta;
  } voxel_result_t;

  typedef struct packed {
    logic [7:0]  code;
    logic [7:0]  error;
    logic [15:0] zero;
    logic [31:0] command_index;
  } error_result_t;

  typedef struct packed {
    logic [7:0]  code;
    logic        shadow;
    logic        by_full;
    logic        by_lines;
    logic        has_fragment;
    logic        overflow;
    logic        off_plane;
    logic [9:0]  zero_high;
    logic [7:0]  object_id;
    logic [15:0] zero_low;
    logic [15:0] number;     // of the item in its command
  } slb_answer_t;

  typedef struct packed {
    logic [7:0]  code;
    logic [23:0] index;
    logic [23:0] zero;
    logic [7:0]  words;      // raw words that follow
  } slb_entry_result_t;

  // ---- Plane ----
  // What the units see of an entry; the generation tag behind `present` stays in mem/.
  typedef struct packed {
    logic        present;
    logic [23:0] depth;
  } plane_entry_t;

  localparam int unsigned GENERATION_BITS = 8;
  localparam int unsigned PLANE_WORD_BITS = 32;   // {generation, depth}
  localparam int unsigned LINE_LOG2       = 4;    // 16 entries to a 64-byte line

  // ---- Fixed formats of the resolve pass (docs/vpu.md) ----
  localparam int unsigned OFFSET_FACTOR_BITS  = 18;
  localparam int unsigned OFFSET_FRAC_BITS    = 16;
  localparam int unsigned SHIFT_BITS          = 6;
  localparam int unsigned MARGIN_BITS         = 24;
  localparam int unsigned DELTA_NORM_BITS     = 12;
  localparam int unsigned GRADIENT_NORM_BITS  = 16;

  // What an item of the projection unit is for.
  localparam int unsigned ITEM_KIND_BITS = 2;
  localparam logic [1:0] ITEM_PROJECT = 2'd0;  // PROJECT_VOXELS
  localparam logic [1:0] ITEM_OFFSET  = 2'd1;  // RESOLVE_VOXELS
  localparam logic [1:0] ITEM_CORNER  = 2'd2;  // PUT_QUADS
  localparam logic [1:0] ITEM_BEAM    = 2'd3;  // RESOLVE_TOPOLOGY
  function automatic bit is_resolved(logic [1:0] kind);
    is_resolved = kind == ITEM_OFFSET || kind == ITEM_BEAM;
  endfunction

  // What travels with the two plane reads of a voxel, so that the unit holds nothing while it waits.
  typedef struct packed {
    logic        facing_away;
    logic        off_plane;
    logic [23:0] depth;      // d
    logic [15:0] facing;     // g_dn
  } own_tag_t;
  localparam int unsigned OWN_TAG_BITS = 42;

  typedef struct packed {
    logic        off_plane;
    logic [23:0] depth;      // d'
    logic [15:0] tilt_u;     // g_un
    logic [15:0] tilt_v;     // g_vn
  } offset_tag_t;
  localparam int unsigned OFFSET_TAG_BITS = 57;

  // Besides, in hardware with the perspective projection, with the own entry's read.
  typedef struct packed {
    logic        behind;
    logic        outside_cone;
    logic [23:0] delta_max;
  } reach_tag_t;
  localparam int unsigned REACH_TAG_BITS = 26;
  function automatic int unsigned own_tag_bits(bit en_perspective);
    own_tag_bits = OWN_TAG_BITS + (en_perspective ? REACH_TAG_BITS : 0);
  endfunction

  // Gradients for the margin test.
  typedef struct packed {
    logic [15:0] facing;     // g_dn
    logic [15:0] tilt_u;     // g_un
    logic [15:0] tilt_v;     // g_vn
  } slopes_t;
  localparam int unsigned SLOPES_BITS = 48;

  // ---- Places: entries with fraction bits, saturated to two planes on either side of the plane; depths before the last floor ----
  localparam int unsigned PLACE_FRAC_BITS = 12;
  localparam int unsigned KEY_FRAC_BITS   = 4;
  function automatic int unsigned place_bits(int unsigned plane_log2);
    place_bits = plane_log2 + 2 + PLACE_FRAC_BITS;
  endfunction

  // ---- Widths of the perspective projection (docs/vpu.md, "Perspective") ----
  localparam int unsigned NORMALISE_BITS = 5;  // a shift of 0..P + 3
  function automatic int unsigned clearance_bits(bit en_perspective, int unsigned d);
    clearance_bits = en_perspective ? 24 : d;  // of RESOLVE_TOPOLOGY
  endfunction
  function automatic int unsigned near_bits(int unsigned p);
    near_bits = p + 4;
  endfunction
  function automatic int unsigned key_bits(int unsigned d);
    key_bits = d + 8;
  endfunction
  function automatic int unsigned light_bits(int unsigned p);
    light_bits = p + 11;
  endfunction
  function automatic int unsigned cone_bits(int unsigned plane_log2);
    cone_bits = 2 * plane_log2 + 18;
  endfunction

  // ---- Widths (docs/vpu.md, "Projection" and "Resolve"; f = MATRIX_FRAC_BITS, P = VOXEL_BITS + VOXEL_FRAC_BITS) ----
  function automatic int unsigned uv_coefficient_bits(int unsigned f);
    uv_coefficient_bits = f + 2;
  endfunction
  function automatic int unsigned uv_constant_bits(int unsigned f, int unsigned p);
    uv_constant_bits = f + p + 3;
  endfunction
  function automatic int unsigned uv_acc_bits(int unsigned f, int unsigned p);
    uv_acc_bits = f + p + 5;
  endfunction
  function automatic int unsigned depth_frac_bits(int unsigned p);
    depth_frac_bits = p + 4;
  endfunction
  function automatic int unsigned depth_coefficient_bits(int unsigned d, int unsigned p);
    depth_coefficient_bits = d + p + 2;
  endfunction
  function automatic int unsigned depth_constant_bits(int unsigned d, int unsigned p);
    depth_constant_bits = d + p + 8;
  endfunction
  function automatic int unsigned depth_acc_bits(int unsigned d, int unsigned p);
    depth_acc_bits = d + 2 * p + 6;
  endfunction
  function automatic int unsigned uv_gradient_bits(int unsigned f, int unsigned n);
    uv_gradient_bits = f + n + 3;
  endfunction
  function automatic int unsigned depth_gradient_bits(int unsigned d, int unsigned p, int unsigned n);
    depth_gradient_bits = d + p + n + 3;
  endfunction
  function automatic int unsigned max_of(int unsigned a, int unsigned b);
    max_of = (a > b) ? a : b;
  endfunction
  // A gradient of so many bits times OFFSET_FACTOR, its fraction dropped.
  function automatic int unsigned step_bits(int unsigned gradient_bits);
    step_bits = gradient_bits + OFFSET_FACTOR_BITS + 1 - OFFSET_FRAC_BITS;
  endfunction

  // ---- Counters ----
  localparam logic [3:0] PASS_IDLE    = 4'd0;
  localparam logic [3:0] PASS_CONTROL = 4'd1;
  localparam logic [3:0] PASS_CLEAR   = 4'd2;
  localparam logic [3:0] PASS_PROJECT = 4'd3;
  localparam logic [3:0] PASS_RESOLVE = 4'd4;
  localparam logic [3:0] PASS_READ    = 4'd5;
  localparam logic [3:0] PASS_DRAW    = 4'd6;
  localparam logic [3:0] PASS_FILL    = 4'd7;
  localparam logic [3:0] PASS_COVER   = 4'd8;
  localparam logic [3:0] PASS_QUERY   = 4'd9;

  localparam logic [2:0] CAUSE_BUSY           = 3'd0;
  localparam logic [2:0] CAUSE_INPUT_STARVED  = 3'd1;
  localparam logic [2:0] CAUSE_OUTPUT_BLOCKED = 3'd2;
  localparam logic [2:0] CAUSE_MEMORY_WAIT    = 3'd3;
  localparam logic [2:0] CAUSE_HAZARD         = 3'd4;
  localparam logic [2:0] CAUSE_IDLE           = 3'd5;

  localparam int unsigned PASS_COUNT  = 10;
  localparam int unsigned CAUSE_COUNT = 6;

  // One bit an event counter, each at most one a cycle.
  typedef struct packed {
    logic command;
    logic error;
    logic voxel_projected;
    logic project_off_plane;
    logic project_saturated;
    logic plane_write;
    logic voxel_resolved;
    logic resolved_facing_away;
    logic resolved_uncertain;
    logic resolved_offset_empty;
    logic resolved_shadow;
  } events_t;

  // Increments of the silhouette-line buffer's event counters in a cycle, in the order of docs/slb.md.
  typedef struct packed {
    logic        object;
    logic        loop;
    logic        loop_short;
    logic        loop_tiny;
    logic [63:0] tiny_area2;
    logic        vertex;
    logic        vertex_repeated;
    logic        crossing;
    logic        chain;
    logic        chain_off_plane;
    logic        chain_dropped;
    logic        chain_reduced;
    logic        group_evicted;
    logic        winding_saturated;
    logic [6:0]  fill_pixels;
    logic        fill_group;
    logic [6:0]  fill_covered;
    logic        cover_sample;
    logic        cover_used;
    logic        query;
    logic        query_shadow;
    logic        query_off_plane;
    logic        query_overflow;
  } slb_events_t;

  // One bit an event counter of the perspective projection; those of quads and topology mode only with EN_VPU_TOPOLOGY.
  typedef struct packed {
    logic project_behind;
    logic resolved_behind;
    logic resolved_outside_cone;
    logic quad_behind;
    logic quad_straddling;
    logic topology_behind;
    logic topology_outside_cone;
  } perspective_events_t;
  localparam int unsigned PERSPECTIVE_COUNTER_COUNT = 7;

  // Indices of the counter read port of gnomon_core.
  localparam int unsigned EVENT_COUNTER_COUNT = 11;  // indices 0.. in the order of events_t
  localparam logic [6:0] COUNTER_STICKY                = 7'd11;
  localparam logic [6:0] COUNTER_SLB                   = 7'd16;  // + number in the order of slb_events_t
  localparam logic [6:0] COUNTER_TOPOLOGY              = 7'd40;  // + number in the order of topology_events_t
  localparam logic [6:0] COUNTER_PERSPECTIVE           = 7'd55;  // + number in the order of perspective_events_t
  localparam logic [6:0] COUNTER_CYCLES                = 7'd64;  // + 6 * pass + cause
  localparam logic [7:0] COUNTER_FRAME                 = 8'd128; // + number in the order of frame_events_t
  localparam int unsigned SLB_COUNTER_COUNT = 23;

endpackage
/* verilator lint_on UNUSEDPARAM */
