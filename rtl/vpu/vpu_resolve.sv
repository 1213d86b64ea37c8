// SPDX-License-Identifier: Apache-2.0
// Resolve pass of offset mode: own entry and that of the offset point, both plane reads at once, then the margin test. What a voxel
// needs after its reads travels with them as tags, so that any number may be under way.

`include "assertions.svh"

module vpu_resolve #(
  parameter int unsigned DEPTH_BITS     = 20,
  parameter int unsigned PLANE_LOG2     = 9,
  parameter bit          EN_PERSPECTIVE = 1'b0,
  // Derived; not to be overridden.
  parameter int unsigned PLACE   = gnomon_pkg::place_bits(PLANE_LOG2),
  parameter int unsigned OWN_TAG = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE)
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  input  logic                                      en_i,     // the pipeline up to the reads moves
  output logic                                      stall_o,  // the reads of the last stage are not both taken
  // Registers.
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]         delta_shift_i,
  input  logic [gnomon_pkg::MARGIN_BITS-1:0]        margin_squared_i,
  input  logic [DEPTH_BITS-1:0]                     delta_max_i,
  // The place of a voxel.
  input  logic                                      off_plane_i,
  input  logic [2*PLANE_LOG2-1:0]                   index_i,
  input  logic [DEPTH_BITS-1:0]                     depth_i,
  // Two stages later: a voxel to resolve, its offset point.
  input  logic                                      valid_i,
  input  logic                                      behind_i,
  input  logic                                      outside_cone_i,
  input  logic                                      facing_away_i,
  input  logic signed [PLACE-1:0]                   u_moved_i, v_moved_i,
  input  logic [DEPTH_BITS-1:0]                     depth_moved_i,
  input  gnomon_pkg::slopes_t                       slopes_i,
  input  logic [DEPTH_BITS-1:0]                     item_delta_max_i,
  // Read port 0: the voxel's own entry.
  output logic                                      read0_valid_o,
  input  logic                                      read0_ready_i,
  output logic [2*PLANE_LOG2-1:0]                   read0_index_o,
  output logic [OWN_TAG-1:0]                        read0_tag_o,
  input  logic                                      entry0_valid_i,
  output logic                                      entry0_ready_o,
  input  gnomon_pkg::plane_entry_t                  entry0_i,
  input  logic [OWN_TAG-1:0]                        entry0_tag_i,
  // Read port 1: the offset point's entry.
  output logic                                      read1_valid_o,
  input  logic                                      read1_ready_i,
  output logic [2*PLANE_LOG2-1:0]                   read1_index_o,
  output gnomon_pkg::offset_tag_t                   read1_tag_o,
  input  logic                                      entry1_valid_i,
  output logic                                      entry1_ready_o,
  input  gnomon_pkg::plane_entry_t                  entry1_i,
  input  gnomon_pkg::offset_tag_t                   entry1_tag_i,
  // VOXEL_STATE results.
  output logic                                      result_valid_o,
  input  logic                                      result_ready_i,
  output gnomon_pkg::voxel_result_t                 result_o
);

  localparam int unsigned INDEX = 2 * PLANE_LOG2;
  localparam int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS;
  localparam int unsigned FRAC  = gnomon_pkg::PLACE_FRAC_BITS;

  // ---- The own entry waits for the offset point ----
  logic                  off_plane4_q, off_plane5_q;
  logic [INDEX-1:0]      index4_q, index5_q;
  logic [DEPTH_BITS-1:0] depth4_q, depth5_q;
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      off_plane4_q <= off_plane_i;
      index4_q     <= index_i;
      depth4_q     <= depth_i;
      off_plane5_q <= off_plane4_q;
      index5_q     <= index4_q;
      depth5_q     <= depth4_q;
    end
  end

  gnomon_pkg::own_tag_t own_tag;
  assign own_tag.facing_away = facing_away_i;
  assign own_tag.off_plane   = off_plane5_q;
  assign own_tag.depth       = DEPTH'(depth5_q);
  assign own_tag.facing      = slopes_i.facing;
  assign read0_index_o       = index5_q;
  assign read0_tag_o[gnomon_pkg::OWN_TAG_BITS-1:0] = own_tag;
  if (EN_PERSPECTIVE) begin : gen_reach
    assign read0_tag_o[OWN_TAG-1:gnomon_pkg::OWN_TAG_BITS] = {behind_i, outside_cone_i, DEPTH'(item_delta_max_i)};
  end else begin : gen_no_reach
    logic unused_reach;
    assign unused_reach = ^{behind_i, outside_cone_i, item_delta_max_i};
  end

  logic unused_fraction;
  assign read1_index_o         = {v_moved_i[FRAC+:PLANE_LOG2], u_moved_i[FRAC+:PLANE_LOG2]};
  assign read1_tag_o.off_plane = u_moved_i[PLACE-1:FRAC+PLANE_LOG2] != '0 || v_moved_i[PLACE-1:FRAC+PLANE_LOG2] != '0;
  assign read1_tag_o.depth     = DEPTH'(depth_moved_i);
  assign read1_tag_o.tilt_u    = slopes_i.tilt_u;
  assign read1_tag_o.tilt_v    = slopes_i.tilt_v;
  assign unused_fraction       = ^{u_moved_i[FRAC-1:0], v_moved_i[FRAC-1:0]};

  // ---- Reads: each port may take its request in another cycle; the stage moves on when both have ----
  logic taken0_q, taken1_q, done0, done1;
  assign read0_valid_o = valid_i && !taken0_q;
  assign read1_valid_o = valid_i && !taken1_q;
  assign done0         = taken0_q || read0_ready_i;
  assign done1         = taken1_q || read1_ready_i;
  assign stall_o       = valid_i && !(done0 && done1);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || en_i) begin
      taken0_q <= 1'b0;
      taken1_q <= 1'b0;
    end else begin
      taken0_q <= valid_i && done0;
      taken1_q <= valid_i && done1;
    end
  end

  vpu_margin #(.DEPTH_BITS(DEPTH_BITS), .EN_PERSPECTIVE(EN_PERSPECTIVE)) u_margin (
    .clk_i, .rst_ni, .delta_shift_i, .margin_squared_i, .delta_max_i,
    .own_valid_i(entry0_valid_i), .own_ready_o(entry0_ready_o), .own_entry_i(entry0_i), .own_tag_i(entry0_tag_i),
    .offset_valid_i(entry1_valid_i), .offset_ready_o(entry1_ready_o), .offset_entry_i(entry1_i),
    .offset_tag_i(entry1_tag_i),
    .result_valid_o, .result_ready_i, .result_o
  );

  `GNOMON_ASSERT_STREAM(a_read0_stable, read0_valid_o, read0_ready_i, {read0_index_o, read0_tag_o})
  `GNOMON_ASSERT_STREAM(a_read1_stable, read1_valid_o, read1_ready_i, {read1_index_o, read1_tag_o})

endmodule
