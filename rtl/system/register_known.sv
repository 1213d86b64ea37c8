// SPDX-License-Identifier: Apache-2.0
// Whether there is a register at an offset of the block. Combinational.

module register_known (
  input  logic [11:0] offset_i,
  output logic        known_o,
  output logic        counter_o   // it is one of the counters' copies
);

  localparam bit [31:0] COUNTERS     = gnomon_registers_pkg::GNOMON_COUNTER_LOW_OFFSET;
  localparam bit [31:0] COUNTERS_END = COUNTERS + gnomon_registers_pkg::GNOMON_COUNTER_LOW_COUNT *
                                                  gnomon_registers_pkg::GNOMON_COUNTER_LOW_STRIDE;
  logic [31:0] offset;
  logic        named;
  assign offset    = {20'd0, offset_i[11:2], 2'b00};  // a multiple of 4 is asked for elsewhere
  assign counter_o = offset >= COUNTERS && offset < COUNTERS_END;
  assign known_o   = (named || counter_o) && offset_i[1:0] == 2'b00;

  always_comb begin
    case (offset)
      gnomon_registers_pkg::GNOMON_ID_OFFSET, gnomon_registers_pkg::GNOMON_VERSION_OFFSET,
      gnomon_registers_pkg::GNOMON_FEATURES_OFFSET, gnomon_registers_pkg::GNOMON_WIDTHS_VOXEL_OFFSET,
      gnomon_registers_pkg::GNOMON_WIDTHS_PLANE_OFFSET, gnomon_registers_pkg::GNOMON_WIDTHS_TOPOLOGY_OFFSET,
      gnomon_registers_pkg::GNOMON_WIDTHS_SLB_OFFSET, gnomon_registers_pkg::GNOMON_WIDTHS_POINT_OFFSET,
      gnomon_registers_pkg::GNOMON_WIDTHS_MEMORY_OFFSET, gnomon_registers_pkg::GNOMON_CONTROL_OFFSET,
      gnomon_registers_pkg::GNOMON_RESET_OFFSET, gnomon_registers_pkg::GNOMON_STATUS_OFFSET,
      gnomon_registers_pkg::GNOMON_AXI_TIMEOUT_OFFSET, gnomon_registers_pkg::GNOMON_PLANE_BASE_LOW_OFFSET,
      gnomon_registers_pkg::GNOMON_PLANE_BASE_HIGH_OFFSET, gnomon_registers_pkg::GNOMON_COMMAND_BASE_LOW_OFFSET,
      gnomon_registers_pkg::GNOMON_COMMAND_BASE_HIGH_OFFSET, gnomon_registers_pkg::GNOMON_COMMAND_SIZE_OFFSET,
      gnomon_registers_pkg::GNOMON_COMMAND_HEAD_OFFSET, gnomon_registers_pkg::GNOMON_COMMAND_TAIL_OFFSET,
      gnomon_registers_pkg::GNOMON_RESULT_BASE_LOW_OFFSET, gnomon_registers_pkg::GNOMON_RESULT_BASE_HIGH_OFFSET,
      gnomon_registers_pkg::GNOMON_RESULT_SIZE_OFFSET, gnomon_registers_pkg::GNOMON_RESULT_HEAD_OFFSET,
      gnomon_registers_pkg::GNOMON_RESULT_TAIL_OFFSET, gnomon_registers_pkg::GNOMON_INTERRUPT_STATUS_OFFSET,
      gnomon_registers_pkg::GNOMON_INTERRUPT_ENABLE_OFFSET, gnomon_registers_pkg::GNOMON_ERROR_STATUS_OFFSET,
      gnomon_registers_pkg::GNOMON_ERROR_ADDRESS_LOW_OFFSET, gnomon_registers_pkg::GNOMON_ERROR_ADDRESS_HIGH_OFFSET,
      gnomon_registers_pkg::GNOMON_JOBS_DONE_OFFSET, gnomon_registers_pkg::GNOMON_JOB_FLAGS_OFFSET,
      gnomon_registers_pkg::GNOMON_SNAPSHOT_OFFSET: named = 1'b1;
      default:                                      named = 1'b0;
    endcase
  end

endmodule
