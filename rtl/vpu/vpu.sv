// SPDX-License-Identifier: Apache-2.0
// Offset mode of the projection unit, behind vpu_front: keeps the nearest depth of each plane entry (project pass) or
// answers each voxel with its state (resolve pass). One item a cycle; docs/vpu.md has the definition and the pipeline.

`include "assertions.svh"

module vpu #(
  parameter int unsigned DEPTH_BITS     = 20,
  parameter int unsigned PLANE_LOG2     = 9,
  parameter bit          EN_VPU_OFFSET  = 1'b1,
  parameter bit          EN_PERSPECTIVE = 1'b0,
  // Derived; not to be overridden.
  parameter int unsigned PLACE   = gnomon_pkg::place_bits(PLANE_LOG2),
  parameter int unsigned OWN_TAG = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // Items on their way into the front end, all of one pass until idle.
  input  logic                                       item_valid_i,
  output logic                                       item_ready_o,
  output logic                                       idle_o,          // no item under way
  // The front end moves; registers of the margin test.
  input  logic                                       en_i,
  output logic                                       stall_o,         // an item waits for the plane
  input  logic [gnomon_pkg::SHIFT_BITS-1:0]          delta_shift_i,
  input  logic [gnomon_pkg::MARGIN_BITS-1:0]         margin_squared_i,
  input  logic [DEPTH_BITS-1:0]                      delta_max_i,
  // The place of an item.
  input  logic                                       valid_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_i,
  input  logic                                       behind_i,
  input  logic signed [PLACE-1:0]                    u_fine_i, v_fine_i,
  input  logic [DEPTH_BITS-1:0]                      depth_i,
  input  logic                                       saturated_i,
  // Two stages later: its offset point.
  input  logic                                       moved_valid_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      moved_kind_i,
  input  logic                                       moved_behind_i,
  input  logic                                       outside_cone_i,
  input  logic                                       facing_away_i,
  input  logic signed [PLACE-1:0]                    u_moved_i, v_moved_i,
  input  logic [DEPTH_BITS-1:0]                      depth_moved_i,
  input  gnomon_pkg::slopes_t                        slopes_i,
  input  logic [DEPTH_BITS-1:0]                      item_delta_max_i,
  // Update port of the plane.
  output logic                                       update_valid_o,
  input  logic                                       update_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    update_index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    update_operand_o,
  input  gnomon_pkg::plane_entry_t                   modify_entry_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    modify_operand_i,
  output logic                                       modify_write_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0]    modify_depth_o,
  // Read ports of the plane.
  output logic                                       read0_valid_o,
  input  logic                                       read0_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    read0_index_o,
  output logic [OWN_TAG-1:0]                         read0_tag_o,
  input  logic                                       entry0_valid_i,
  output logic                                       entry0_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry0_i,
  input  logic [OWN_TAG-1:0]                         entry0_tag_i,
  output logic                                       read1_valid_o,
  input  logic                                       read1_ready_i,
  output logic [2*PLANE_LOG2-1:0]                    read1_index_o,
  output gnomon_pkg::offset_tag_t                    read1_tag_o,
  input  logic                                       entry1_valid_i,
  output logic                                       entry1_ready_o,
  input  gnomon_pkg::plane_entry_t                   entry1_i,
  input  gnomon_pkg::offset_tag_t                    entry1_tag_i,
  // VOXEL_STATE results.
  output logic                                       result_valid_o,
  input  logic                                       result_ready_i,
  output gnomon_pkg::voxel_result_t                  result_o,
  // Events of the project pass, one cycle a voxel.
  output logic                                       projected_o,
  output logic                                       off_plane_o,
  output logic                                       saturated_o,
  output logic                                       behind_o
);

  // ---- Items under way; with the count at its end no item is taken, so that it never wraps whatever the latency ----
  localparam int unsigned COUNT_BITS = 10;
  logic [COUNT_BITS-1:0] count_q;
  logic                  count_full, take, give, update_stall, read_stall;
  assign count_full   = count_q == '1;
  assign stall_o      = update_stall || read_stall;
  assign item_ready_o = en_i && !count_full;
  assign take         = item_valid_i && item_ready_o;
  assign idle_o       = count_q == '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)            count_q <= '0;
    else if (take && !give) count_q <= count_q + 1'b1;
    else if (!take && give) count_q <= count_q - 1'b1;
  end

  // ---- The place as an entry: 0 <= u, v < 2^PLANE_LOG2 has no bit set above ----
  localparam int unsigned FRAC  = gnomon_pkg::PLACE_FRAC_BITS;
  localparam int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS;
  logic                    off_plane;
  logic [2*PLANE_LOG2-1:0] index;
  logic                    unused_fraction;
  assign off_plane       = u_fine_i[PLACE-1:FRAC+PLANE_LOG2] != '0 || v_fine_i[PLACE-1:FRAC+PLANE_LOG2] != '0;
  assign index           = {v_fine_i[FRAC+:PLANE_LOG2], u_fine_i[FRAC+:PLANE_LOG2]};
  assign unused_fraction = ^{u_fine_i[FRAC-1:0], v_fine_i[FRAC-1:0]};

  // ---- Project pass: an item offers its depth to the plane ----
  logic project;
  assign project          = valid_i && kind_i == gnomon_pkg::ITEM_PROJECT;
  assign update_valid_o   = project && !behind_i && !off_plane;
  assign update_index_o   = index;
  assign update_operand_o = DEPTH'(depth_i);
  assign update_stall     = update_valid_o && !update_ready_i;
  vpu_nearest u_nearest (
    .entry_i(modify_entry_i), .depth_i(modify_operand_i), .write_o(modify_write_o), .depth_o(modify_depth_o)
  );

  assign projected_o = project && en_i;
  assign off_plane_o = projected_o && !behind_i && off_plane;
  assign saturated_o = projected_o && !behind_i && !off_plane && saturated_i;
  assign behind_o    = projected_o && behind_i;
  assign give        = projected_o || (result_valid_o && result_ready_i);

  // ---- Resolve pass ----
  if (EN_VPU_OFFSET) begin : gen_resolve
    vpu_resolve #(
      .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE)
    ) u_resolve (
      .clk_i, .rst_ni, .en_i, .stall_o(read_stall), .delta_shift_i, .margin_squared_i, .delta_max_i,
      .off_plane_i(off_plane), .index_i(index), .depth_i,
      .valid_i(moved_valid_i && moved_kind_i == gnomon_pkg::ITEM_OFFSET), .behind_i(moved_behind_i), .outside_cone_i,
      .facing_away_i, .u_moved_i, .v_moved_i, .depth_moved_i, .slopes_i, .item_delta_max_i,
      .read0_valid_o, .read0_ready_i, .read0_index_o, .read0_tag_o,
      .entry0_valid_i, .entry0_ready_o, .entry0_i, .entry0_tag_i,
      .read1_valid_o, .read1_ready_i, .read1_index_o, .read1_tag_o,
      .entry1_valid_i, .entry1_ready_o, .entry1_i, .entry1_tag_i,
      .result_valid_o, .result_ready_i, .result_o
    );
  end else begin : gen_no_resolve
    assign read_stall     = 1'b0;
    assign read0_valid_o  = 1'b0;
    assign read0_index_o  = '0;
    assign read0_tag_o    = '0;
    assign entry0_ready_o = 1'b1;
    assign read1_valid_o  = 1'b0;
    assign read1_index_o  = '0;
    assign read1_tag_o    = '0;
    assign entry1_ready_o = 1'b1;
    assign result_valid_o = 1'b0;
    assign result_o       = '0;

    logic unused_resolve;
    assign unused_resolve = ^{
      moved_valid_i, moved_kind_i, moved_behind_i, outside_cone_i, facing_away_i, u_moved_i, v_moved_i, depth_moved_i,
      slopes_i, item_delta_max_i, delta_shift_i, margin_squared_i, delta_max_i, read0_ready_i, read1_ready_i,
      entry0_valid_i, entry0_i, entry0_tag_i, entry1_valid_i, entry1_i, entry1_tag_i, result_ready_i
    };
  end

  `GNOMON_ASSERT_STREAM(a_update_stable, update_valid_o, update_ready_i, {update_index_o, update_operand_o})

endmodule
