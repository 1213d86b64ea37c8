// SPDX-License-Identifier: Apache-2.0
// Four corners become a quad: its number, its box on the plane, its far depth and its record. Quads that miss the plane,
// or have a corner behind the light, end here. A corner a cycle.

`include "assertions.svh"

module topology_quad #(
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 9,
  parameter int unsigned SUB_BITS   = 4,
  parameter int unsigned SPAN_LOG2  = 4,
  parameter int unsigned QUADS_LOG2 = 18,
  // Derived; not to be overridden.
  parameter int unsigned COORDINATE = PLANE_LOG2 + SUB_BITS + 2,
  parameter int unsigned RECORD     = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2)
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         clear_i,       // numbers begin again; only between quads
  input  logic                         corner_valid_i,
  output logic                         corner_ready_o,
  input  logic                         behind_i,      // the rest of the corner means nothing then
  input  logic signed [COORDINATE-1:0] u_i, v_i,      // sub-entries
  input  logic [DEPTH_BITS-1:0]        depth_i,
  input  logic                         saturated_i,   // the depth was
  output logic                         quad_valid_o,
  input  logic                         quad_ready_i,
  output logic                         storable_o,
  output logic [QUADS_LOG2-1:0]        number_o,
  output logic [DEPTH_BITS-1:0]        far_o,
  output logic [PLANE_LOG2-1:0]        u_low_o, u_high_o, v_low_o, v_high_o,  // box, clipped to the plane
  output logic [RECORD-1:0]            record_o,
  output logic                         idle_o,
  // Events, one cycle a quad.
  output logic                         put_o,
  output logic                         clipped_o,     // its box was clipped or misses the plane
  output logic                         missed_o,
  output logic                         too_large_o,
  output logic                         saturated_o,
  output logic                         behind_o,      // all corners are
  output logic                         straddling_o   // some are
);

  localparam int unsigned C     = COORDINATE;
  localparam int unsigned ENTRY = PLANE_LOG2 + 2;        // signed
  localparam int unsigned D     = DEPTH_BITS;
  localparam int unsigned DELTA = SPAN_LOG2 + SUB_BITS;  // du, dv

  // ---- The corners so far; `count_q` says how many ----
  logic [1:0]              count_q;
  logic                    first, last, take;
  logic [4*C-1:0]          us_q, vs_q;                       // corner 0 in the low bits
  logic signed [ENTRY-1:0] u, v, u_low, u_high, v_low, v_high;
  logic signed [ENTRY-1:0] u_low_q, u_high_q, v_low_q, v_high_q;
  logic [D-1:0]            far, far_q;
  logic                    saturated, saturated_q, full_q, leave;
  logic                    all_behind, all_behind_q, some_behind, some_behind_q;

  assign first          = count_q == 2'd0;
  assign last           = count_q == 2'd3;
  assign corner_ready_o = !full_q || leave;
  assign take           = corner_valid_i && corner_ready_o;

  assign u         = u_i[C-1:SUB_BITS];  // floor to entries
  assign v         = v_i[C-1:SUB_BITS];
  assign u_low     = (first || u < u_low_q) ? u : u_low_q;
  assign u_high    = (first || u > u_high_q) ? u : u_high_q;
  assign v_low     = (first || v < v_low_q) ? v : v_low_q;
  assign v_high    = (first || v > v_high_q) ? v : v_high_q;
  assign far       = (first || depth_i > far_q) ? depth_i : far_q;
  assign saturated = saturated_i || (!first && saturated_q);
  assign all_behind  = behind_i && (first || all_behind_q);
  assign some_behind = behind_i || (!first && some_behind_q);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q <= '0;
      full_q  <= 1'b0;
    end else begin
      if (take)  count_q <= count_q + 2'd1;
      if (take)       full_q <= last;
      else if (leave) full_q <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take) begin
      us_q          <= {u_i, us_q[4*C-1:C]};
      vs_q          <= {v_i, vs_q[4*C-1:C]};
      u_low_q       <= u_low;
      u_high_q      <= u_high;
      v_low_q       <= v_low;
      v_high_q      <= v_high;
      far_q         <= far;
      saturated_q   <= saturated;
      all_behind_q  <= all_behind;
      some_behind_q <= some_behind;
    end
  end

  // ---- A whole quad: clip, number, record ----
  localparam logic signed [ENTRY-1:0] SIDE_LAST = (ENTRY'(1) << PLANE_LOG2) - ENTRY'(1);
  logic [topology_pkg::NUMBER_BITS-1:0] number_q;
  logic                                 missed, clipped, too_large;
  logic [ENTRY-1:0]                     u_span, v_span;  // 0..2^ENTRY - 1: unsigned
  assign missed    = u_high_q[ENTRY-1] || v_high_q[ENTRY-1] || u_low_q > SIDE_LAST || v_low_q > SIDE_LAST;
  assign clipped   = missed || u_low_q[ENTRY-1] || v_low_q[ENTRY-1] || u_high_q > SIDE_LAST || v_high_q > SIDE_LAST;
  assign u_span    = u_high_q - u_low_q;
  assign v_span    = v_high_q - v_low_q;
  assign too_large = (u_span >> SPAN_LOG2) != '0 || (v_span >> SPAN_LOG2) != '0;

  logic ends;
  assign ends         = missed || (mutations_pkg::PERSPECTIVE_KEEP_STRADDLING ? all_behind_q : some_behind_q);
  assign quad_valid_o = full_q && !ends;
  assign leave        = full_q && (ends || quad_ready_i);
  assign storable_o   = !too_large && (number_q >> QUADS_LOG2) == '0 && number_q != '1;  // all ones means none
  assign number_o     = number_q[QUADS_LOG2-1:0];
  assign far_o        = far_q;
  assign u_low_o      = u_low_q[ENTRY-1] ? '0 : u_low_q[PLANE_LOG2-1:0];
  assign v_low_o      = v_low_q[ENTRY-1] ? '0 : v_low_q[PLANE_LOG2-1:0];
  assign u_high_o     = u_high_q > SIDE_LAST ? {{(PLANE_LOG2 - 1){1'b1}}, !mutations_pkg::TOPOLOGY_CLIP_SHORT}
                                             : u_high_q[PLANE_LOG2-1:0];
  assign v_high_o     = v_high_q > SIDE_LAST ? '1 : v_high_q[PLANE_LOG2-1:0];

  // From the base: the fraction stays, entries below 2^SPAN_LOG2 where the quad is storable.
  for (genvar i = 0; i < 4; i++) begin : gen_record
    logic [ENTRY-1:0] du, dv;
    logic             unused_high;
    assign du          = us_q[i*C+SUB_BITS+:ENTRY] - u_low_q;
    assign dv          = vs_q[i*C+SUB_BITS+:ENTRY] - v_low_q;
    assign unused_high = ^{du >> SPAN_LOG2, dv >> SPAN_LOG2};
    assign record_o[i*2*DELTA+:DELTA]       = {du[SPAN_LOG2-1:0], us_q[i*C+:SUB_BITS]};
    assign record_o[i*2*DELTA+DELTA+:DELTA] = {dv[SPAN_LOG2-1:0], vs_q[i*C+:SUB_BITS]};
  end
  assign record_o[8*DELTA+:2*SPAN_LOG2] = {v_low_q[SPAN_LOG2-1:0], u_low_q[SPAN_LOG2-1:0]};

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i)           number_q <= '0;
    else if (leave && number_q != '1) number_q <= number_q + 1'b1;  // sticks at the last
  end

  assign idle_o       = !full_q;
  assign put_o        = leave;
  assign clipped_o    = leave && !some_behind_q && clipped;
  assign missed_o     = leave && !some_behind_q && missed;
  assign too_large_o  = leave && !ends && too_large;
  assign saturated_o  = leave && !ends && saturated_q;
  assign behind_o     = leave && all_behind_q;
  assign straddling_o = leave && some_behind_q && !all_behind_q;

  `GNOMON_ASSERT(a_clear_between_quads, !clear_i || (count_q == '0 && !full_q && !corner_valid_i))
  `GNOMON_ASSERT_STREAM(a_quad_stable, quad_valid_o, quad_ready_i, {number_o, far_o, record_o, u_low_o, v_high_o})

endmodule
