// SPDX-License-Identifier: Apache-2.0
// A stand-in with the ports of gnomon_core that compiles in a second: NOP, FENCE and READ_PLANE alone, and faults by define.
// It has no projection; READ_PLANE returns words of a memory that nothing writes, so they show the random power-up content.

module gnomon_core #(
  parameter int unsigned VOXEL_BITS = 8,
  parameter int unsigned VOXEL_FRAC_BITS = 2,
  parameter int unsigned NORMAL_BITS = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned PLANE_LOG2 = 9,
  parameter bit          EN_VPU_OFFSET = 1'b1,
  parameter int unsigned MEM_LATENCY = 1,
  parameter int unsigned MEM_STALL_SEED = 0
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        cmd_valid_i,
  output logic        cmd_ready_o,
  input  logic [63:0] cmd_data_i,
  output logic        res_valid_o,
  input  logic        res_ready_i,
  output logic [63:0] res_data_o,
  input  logic [6:0]  counter_index_i,
  output logic [63:0] counter_value_o,
  output logic        idle_o
);

  if (PLANE_LOG2 > 12) begin : gen_bad_plane
    $error("PLANE_LOG2=%0d is out of range 4..12", PLANE_LOG2);
  end

  logic [31:0] memory [256];
  logic [63:0] cycles, commands, starved;
  logic [15:0] items_left;
  logic [8:0]  reads_left;
  logic [7:0]  address;

  logic take;
  assign take = cmd_valid_i && cmd_ready_o;
  assign idle_o = !res_valid_o && reads_left == 0;
  assign counter_value_o = (counter_index_i == 7'd0)  ? commands :
                           (counter_index_i == 7'd64) ? cycles - starved :
                           (counter_index_i == 7'd65) ? starved : 64'd0;
`ifdef TINY_HANGS
  assign cmd_ready_o = commands < 64'd3;
`else
  assign cmd_ready_o = reads_left == 0 && (!res_valid_o || res_ready_i);
`endif

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      cycles      <= 64'd0;
      commands    <= 64'd0;
      starved     <= 64'd0;
      items_left  <= 16'd0;
      reads_left  <= 9'd0;
      res_valid_o <= 1'b0;
    end else begin
      cycles <= cycles + 64'd1;
      if (cmd_ready_o && !cmd_valid_i) starved <= starved + 64'd1;
      if (res_ready_i) res_valid_o <= 1'b0;
      if (reads_left != 0 && (!res_valid_o || res_ready_i)) begin
        res_valid_o <= 1'b1;
        res_data_o  <= {8'h04, 16'd0, address, 1'b1, 7'd0, memory[address][23:0]};
        address     <= address + 8'd1;
        reads_left  <= reads_left - 9'd1;
      end
      if (take && items_left != 0) items_left <= items_left - 16'd1;
      if (take && items_left == 0) begin
        items_left <= cmd_data_i[47:32];
        commands   <= commands + 64'd1;
        if (cmd_data_i[63:56] == 8'h03) begin
          res_valid_o <= 1'b1;
          res_data_o  <= {8'h03, 24'd0, cmd_data_i[31:0]};
        end
        if (cmd_data_i[63:56] == 8'h04) begin
          address    <= cmd_data_i[7:0];
          reads_left <= {1'b0, cmd_data_i[31:24]} + 9'd1;
        end
      end
`ifdef TINY_ASSERTS
      tiny_never_five: assert (commands != 64'd5);
`endif
    end
  end

endmodule
