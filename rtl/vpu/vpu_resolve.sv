// SPDX-License-Identifier: Apache-2.0
// Resolve pass of offset mode: entry of the offset point, both plane reads at once, then the margin test. What a voxel
// needs after its reads travels with them as tags, so that any number may be under way.

`include "assertions.svh"

module vpu_resolve #(
  parameter int unsigned POSITION_BITS    = 10,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  // Derived; not to be overridden.
  parameter int unsigned UV_G   = gnomon_pkg::uv_gradient_bits(MATRIX_FRAC_BITS, NORMAL_BITS),
  parameter int unsigned D_G    = gnomon_pkg::depth_gradient_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned UV_SUM = gnomon_pkg::uv_offset_bits(MATRIX_FRAC_BITS, POSITION_BITS, NORMAL_BITS),
  parameter int unsigned D_SUM  = gnomon_pkg::depth_offset_bits(DEPTH_BITS, POSITION_BITS, NORMAL_BITS)
) (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  input  logic                                      en_i,     // the pipeline up to the reads moves
  output logic                                      stall_o,  // the reads of the last stage are not both taken
  // Registers.
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]         facing_shift_i, tilt_shift_i, delta_shift_i,
  input  logic [gnomon_pkg::MARGIN_BITS-1:0]        margin_squared_i,
  input  logic [DEPTH_BITS-1:0]                     delta_max_i,
  // Stage 3: a voxel to resolve with its place on the plane, the gradient of its normal; stage 4: its offset point.
  input  logic                                      valid_i,
  input  logic                                      off_plane_i,
  input  logic [2*PLANE_LOG2-1:0]                   index_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]   depth_i,
  input  logic signed [UV_G-1:0]                    g_u_i, g_v_i,
  input  logic signed [D_G-1:0]                     g_d_i,
  input  logic                                      facing_away_i,
  input  logic signed [UV_SUM-1:0]                  u_sum_i, v_sum_i,
  input  logic signed [D_SUM-1:0]                   d_sum_i,
  // Read port 0: the voxel's own entry.
  output logic                                      read0_valid_o,
  input  logic                                      read0_ready_i,
  output logic [2*PLANE_LOG2-1:0]                   read0_index_o,
  output gnomon_pkg::own_tag_t                      read0_tag_o,
  input  logic                                      entry0_valid_i,
  output logic                                      entry0_ready_o,
  input  gnomon_pkg::plane_entry_t                  entry0_i,
  input  gnomon_pkg::own_tag_t                      entry0_tag_i,
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

  // ---- Stages 4 and 5: offset point; the own entry goes along ----
  vpu_offset #(
    .POSITION_BITS(POSITION_BITS), .NORMAL_BITS(NORMAL_BITS), .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS),
    .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2)
  ) u_offset (
    .clk_i, .en_i, .facing_shift_i, .tilt_shift_i, .g_u_i, .g_v_i, .g_d_i, .u_sum_i, .v_sum_i, .d_sum_i,
    .off_plane_o(read1_tag_o.off_plane), .index_o(read1_index_o), .depth_o(read1_tag_o.depth),
    .facing_o(read0_tag_o.facing), .tilt_u_o(read1_tag_o.tilt_u), .tilt_v_o(read1_tag_o.tilt_v)
  );

  logic             valid4_q, valid5_q, facing_away4_q, facing_away5_q, off_plane4_q, off_plane5_q;
  logic [INDEX-1:0] index4_q, index5_q;
  logic [DEPTH-1:0] depth4_q, depth5_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid4_q <= 1'b0;
      valid5_q <= 1'b0;
    end else if (en_i) begin
      valid4_q <= valid_i;
      valid5_q <= valid4_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      facing_away4_q <= facing_away_i;
      off_plane4_q   <= off_plane_i;
      index4_q       <= index_i;
      depth4_q       <= depth_i;
      facing_away5_q <= facing_away4_q;
      off_plane5_q   <= off_plane4_q;
      index5_q       <= index4_q;
      depth5_q       <= depth4_q;
    end
  end

  assign read0_index_o           = index5_q;
  assign read0_tag_o.facing_away = facing_away5_q;
  assign read0_tag_o.off_plane   = off_plane5_q;
  assign read0_tag_o.depth       = depth5_q;

  // ---- Reads: each port may take its request in another cycle; the stage moves on when both have ----
  logic taken0_q, taken1_q, done0, done1;
  assign read0_valid_o = valid5_q && !taken0_q;
  assign read1_valid_o = valid5_q && !taken1_q;
  assign done0         = taken0_q || read0_ready_i;
  assign done1         = taken1_q || read1_ready_i;
  assign stall_o       = valid5_q && !(done0 && done1);
  always_ff @(posedge clk_i) begin
    if (!rst_ni || en_i) begin
      taken0_q <= 1'b0;
      taken1_q <= 1'b0;
    end else begin
      taken0_q <= valid5_q && done0;
      taken1_q <= valid5_q && done1;
    end
  end

  vpu_margin #(.DEPTH_BITS(DEPTH_BITS)) u_margin (
    .clk_i, .rst_ni, .delta_shift_i, .margin_squared_i, .delta_max_i,
    .own_valid_i(entry0_valid_i), .own_ready_o(entry0_ready_o), .own_entry_i(entry0_i), .own_tag_i(entry0_tag_i),
    .offset_valid_i(entry1_valid_i), .offset_ready_o(entry1_ready_o), .offset_entry_i(entry1_i),
    .offset_tag_i(entry1_tag_i),
    .result_valid_o, .result_ready_i, .result_o
  );

  `GNOMON_ASSERT_STREAM(a_read0_stable, read0_valid_o, read0_ready_i, {read0_index_o, read0_tag_o})
  `GNOMON_ASSERT_STREAM(a_read1_stable, read1_valid_o, read1_ready_i, {read1_index_o, read1_tag_o})

endmodule
