// SPDX-License-Identifier: Apache-2.0
// Decides a voxel from its two plane entries: nothing nearer, empty, or the slope-scaled margin test
// (delta_n·g_dn)² > MARGIN_SQUARED·(g_un² + g_vn²). Five stages: compare; normalise and square; multiply and add; square
// and scale; encode.

`include "assertions.svh"

module vpu_margin #(
  parameter int unsigned DEPTH_BITS     = 20,
  parameter bit          EN_PERSPECTIVE = 1'b0,
  // Derived; not to be overridden.
  parameter int unsigned OWN_TAG = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE)
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]     delta_shift_i,
  input  logic [gnomon_pkg::MARGIN_BITS-1:0]    margin_squared_i,
  input  logic [DEPTH_BITS-1:0]                 delta_max_i,
  // The voxel's own entry and the entry of its offset point, each with what was known when it was asked for.
  input  logic                                  own_valid_i,
  output logic                                  own_ready_o,
  input  gnomon_pkg::plane_entry_t              own_entry_i,
  input  logic [OWN_TAG-1:0]                    own_tag_i,
  input  logic                                  offset_valid_i,
  output logic                                  offset_ready_o,
  input  gnomon_pkg::plane_entry_t              offset_entry_i,
  input  gnomon_pkg::offset_tag_t               offset_tag_i,
  output logic                                  result_valid_o,
  input  logic                                  result_ready_i,
  output gnomon_pkg::voxel_result_t             result_o
);

  localparam int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS;
  localparam int unsigned NORM  = gnomon_pkg::GRADIENT_NORM_BITS;
  localparam int unsigned DNORM = gnomon_pkg::DELTA_NORM_BITS;
  localparam int unsigned LHS   = DNORM + NORM;                             // delta_n·g_dn
  localparam int unsigned TILT  = 2 * NORM + 1;                             // g_un² + g_vn²
  localparam int unsigned RHS   = gnomon_pkg::MARGIN_BITS + TILT;

  // The stages move together; both entries are taken in the same cycle.
  logic [5:1] valid_q;
  logic       en;
  assign en             = !valid_q[5] || result_ready_i;
  assign own_ready_o    = en && offset_valid_i;
  assign offset_ready_o = en && own_valid_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (en) valid_q <= {valid_q[4:1], own_valid_i && offset_valid_i};
  end

  // ---- What came with the own entry ----
  gnomon_pkg::own_tag_t   own_tag;
  gnomon_pkg::reach_tag_t reach;    // outside of the block below: Yosys asks for it
  logic                   behind, outside_cone, unreached;
  logic [DEPTH-1:0]       delta_max;  // in stage 1
  assign own_tag   = own_tag_i[gnomon_pkg::OWN_TAG_BITS-1:0];
  assign unreached = behind || outside_cone;
  if (EN_PERSPECTIVE) begin : gen_reach
    logic [DEPTH-1:0] delta_max1_q;
    logic             unused_delta_max;
    assign reach            = own_tag_i[OWN_TAG-1:gnomon_pkg::OWN_TAG_BITS];
    assign behind           = reach.behind;
    assign outside_cone     = reach.outside_cone;
    assign delta_max        = delta_max1_q;
    assign unused_delta_max = ^delta_max_i;
    always_ff @(posedge clk_i) begin
      if (en) delta_max1_q <= reach.delta_max;
    end
  end else begin : gen_no_reach
    logic unused_reach;
    assign reach        = '0;
    assign behind       = 1'b0;
    assign outside_cone = 1'b0;
    assign delta_max    = DEPTH'(delta_max_i);
    assign unused_reach = ^reach;
  end

  // ---- Stage 1: what the own entry says; delta ----
  logic             own_hole, uncertain, offset_hole, farther;
  logic [DEPTH-1:0] delta;
  assign own_hole    = own_tag.off_plane || !own_entry_i.present;
  assign uncertain   = !unreached && !own_tag.facing_away && !own_hole && own_entry_i.depth < own_tag.depth;
  assign offset_hole = offset_tag_i.off_plane || !offset_entry_i.present;
  assign farther     = uncertain && !offset_hole && offset_tag_i.depth > offset_entry_i.depth;
  assign delta       = farther ? offset_tag_i.depth - offset_entry_i.depth : '0;  // max(0, ...), below 2^DEPTH_BITS

  // The answer so far travels in the result word itself; code and state are set at the end.
  gnomon_pkg::voxel_result_t so_far, result1_q, result2_q, result3_q, result4_q;
  always_comb begin
    so_far              = '0;
    so_far.facing_away  = own_tag.facing_away && !unreached;
    so_far.off_plane    = own_tag.off_plane && !behind;
    so_far.beyond_max   = behind;
    so_far.unreached    = unreached;
    so_far.uncertain    = uncertain;
    so_far.offset_empty = uncertain && offset_hole;
    so_far.nearest      = (unreached || own_tag.facing_away || own_hole) ? '1 : own_entry_i.depth;
    so_far.delta        = delta;
  end

  logic [NORM-1:0] facing1_q, tilt_u1_q, tilt_v1_q;

  // ---- Stage 2: normalise, square ----
  logic               beyond_max;
  logic [DNORM-1:0]   delta_norm, delta2_q;
  logic [NORM-1:0]    facing2_q;
  logic [2*NORM-1:0]  tilt_u2_q, tilt_v2_q;
  assign beyond_max = result1_q.delta > delta_max;
  vpu_normalise #(.IN_BITS(DEPTH), .OUT_BITS(DNORM)) u_delta (
    .value_i(result1_q.delta), .shift_i(delta_shift_i), .value_o(delta_norm)
  );

  // ---- Stages 3 and 4: both sides of the comparison, exact ----
  logic [LHS-1:0]   lhs3_q;
  logic [TILT-1:0]  tilt3_q;
  logic [2*LHS-1:0] lhs4_q;  // 56 bits
  logic [RHS-1:0]   rhs4_q;  // 57 bits

  // ---- Stage 5: encode ----
  logic                      above, shadow;
  gnomon_pkg::voxel_result_t final_result, result5_q;
  assign above  = RHS'(lhs4_q) > rhs4_q || (mutations_pkg::MARGIN_OR_EQUAL && RHS'(lhs4_q) == rhs4_q);
  assign shadow = result4_q.unreached || result4_q.facing_away || result4_q.beyond_max || above;
  always_comb begin
    final_result       = result4_q;
    final_result.code  = gnomon_pkg::RESULT_VOXEL_STATE;
    final_result.state = shadow ? gnomon_pkg::STATE_SHADOW : gnomon_pkg::STATE_LIT;
  end

  always_ff @(posedge clk_i) begin
    if (en) begin
      result1_q <= so_far;
      facing1_q <= own_tag.facing;
      tilt_u1_q <= offset_tag_i.tilt_u;
      tilt_v1_q <= offset_tag_i.tilt_v;

      result2_q            <= result1_q;
      result2_q.beyond_max <= result1_q.beyond_max || beyond_max;
      delta2_q             <= delta_norm;
      facing2_q            <= facing1_q;
      tilt_u2_q            <= (2*NORM)'(tilt_u1_q) * (2*NORM)'(tilt_u1_q);
      tilt_v2_q            <= (2*NORM)'(tilt_v1_q) * (2*NORM)'(tilt_v1_q);

      result3_q <= result2_q;
      lhs3_q    <= LHS'(delta2_q) * LHS'(facing2_q);
      tilt3_q   <= TILT'(tilt_u2_q) + TILT'(tilt_v2_q);

      result4_q <= result3_q;
      lhs4_q    <= (2*LHS)'(lhs3_q) * (2*LHS)'(lhs3_q);
      rhs4_q    <= RHS'(margin_squared_i) * RHS'(tilt3_q);

      result5_q <= final_result;
    end
  end

  assign result_valid_o = valid_q[5];
  assign result_o       = result5_q;

  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
