// SPDX-License-Identifier: Apache-2.0
// Registers on AXI4-Lite: axil_slave and register_file.

module register_block #(
  parameter logic [31:0] FEATURES        = '0,
  parameter logic [31:0] WIDTHS_VOXEL    = '0,
  parameter logic [31:0] WIDTHS_PLANE    = '0,
  parameter logic [31:0] WIDTHS_TOPOLOGY = '0,
  parameter logic [31:0] WIDTHS_SLB      = '0,
  parameter logic [31:0] WIDTHS_POINT    = '0,
  parameter logic [31:0] WIDTHS_MEMORY   = '0
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  system_pkg::axil_want_t axil_i,
  output system_pkg::axil_give_t axil_o,
  // State of the hardware.
  input  logic                   idle_i,
  input  logic                   untouched_i,   // no command word was taken since reset
  input  logic                   result_blocked_i,
  input  logic                   stopped_i,
  input  logic                   late_i,
  input  logic                   resetting_i,
  input  logic [31:0]            error_status_i,
  input  logic [63:0]            error_address_i,
  input  logic [23:0]            job_flags_i,
  // What happens.
  input  logic                   stop_i,        // the hardware stops
  input  logic                   job_done_i,
  input  logic                   interrupt_i,   // the job wants to be told of
  input  logic                   result_full_i,
  input  logic                   tail_step_i,   // a descriptor is finished
  input  logic [3:0]             head_step_i,   // so many results lie in memory
  // Counters.
  output logic [7:0]             counter_index_o,
  input  logic [63:0]            counter_value_i,
  output logic                   snapshot_o,
  // Settings.
  output logic                   soft_reset_o,  // asked for in this cycle; the registers reset themselves until it is over
  output logic                   enable_o,
  output logic                   source_o,
  output logic [31:0]            axi_timeout_o,
  output logic [63:0]            plane_base_o,
  output system_pkg::ring_t      command_ring_o,
  output system_pkg::ring_t      result_ring_o,
  output logic                   irq_o
);

  logic        write, write_known, read_known;
  logic [11:0] write_offset, read_offset;
  logic [31:0] write_data, read_data;
  axil_slave u_slave (
    .clk_i, .rst_ni, .axil_i, .axil_o, .write_o(write), .write_offset_o(write_offset), .write_data_o(write_data),
    .write_known_i(write_known), .read_offset_o(read_offset), .read_data_i(read_data), .read_known_i(read_known)
  );
  register_file #(
    .FEATURES(FEATURES), .WIDTHS_VOXEL(WIDTHS_VOXEL), .WIDTHS_PLANE(WIDTHS_PLANE), .WIDTHS_TOPOLOGY(WIDTHS_TOPOLOGY),
    .WIDTHS_SLB(WIDTHS_SLB), .WIDTHS_POINT(WIDTHS_POINT), .WIDTHS_MEMORY(WIDTHS_MEMORY)
  ) u_file (
    .clk_i, .rst_ni, .write_i(write), .write_offset_i(write_offset), .write_data_i(write_data),
    .write_known_o(write_known), .read_offset_i(read_offset), .read_data_o(read_data), .read_known_o(read_known),
    .idle_i, .untouched_i, .result_blocked_i, .stopped_i, .late_i, .resetting_i, .error_status_i, .error_address_i,
    .job_flags_i, .stop_i, .job_done_i, .interrupt_i, .result_full_i, .tail_step_i, .head_step_i, .counter_index_o,
    .counter_value_i, .snapshot_o, .soft_reset_o, .enable_o, .source_o, .axi_timeout_o, .plane_base_o,
    .command_ring_o, .result_ring_o, .irq_o
  );

endmodule
