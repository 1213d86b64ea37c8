// SPDX-License-Identifier: Apache-2.0
// Update port of the plane: read an entry, let the unit modify it, write it back; one update a cycle, in order, whatever
// entries they hit. Writes that are still on their way are forwarded to the updates behind them:
//
//   take ─► RAM read, READ_LATENCY cycles ─► modify ─► write register ─► RAM write
//             ▲ every stage watches the write register, and keeps what goes to its own entry

module plane_update #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned OPERAND_BITS = 24,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Updates; always taken.
  input  logic                     valid_i,
  input  logic [INDEX_BITS-1:0]    index_i,
  input  logic [OPERAND_BITS-1:0]  operand_i,
  // The RAM's answer to the read of `index_i`, READ_LATENCY cycles later.
  input  gnomon_pkg::plane_entry_t ram_entry_i,
  // The unit's modify function, combinational. What it writes makes the entry present.
  output gnomon_pkg::plane_entry_t modify_entry_o,
  output logic [OPERAND_BITS-1:0]  modify_operand_o,
  input  logic                     modify_write_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] modify_depth_i,
  // Write back.
  output logic                     write_o,
  output logic [INDEX_BITS-1:0]    write_index_o,
  output logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] write_depth_o,
  // Nothing on its way: every update taken is in the RAM.
  output logic                     idle_o
);

  localparam int unsigned STAGES = READ_LATENCY;
  localparam int unsigned DEPTH  = gnomon_pkg::DEPTH_FIELD_BITS;

  logic                  write_q;
  logic [INDEX_BITS-1:0] write_index_q;
  logic [DEPTH-1:0] write_depth_q;

  // Slice s is what stage s works on: 0 is the update being taken, STAGES the one being modified.
  logic [STAGES:0]                    valid, forwarded;
  logic [(STAGES+1)*INDEX_BITS-1:0]   index;
  logic [(STAGES+1)*OPERAND_BITS-1:0] operand;
  logic [(STAGES+1)*DEPTH-1:0]   depth;  // where forwarded

  logic forward;
  assign forward = write_q && !mutations_pkg::NO_FORWARDING;

  assign valid[0]                 = valid_i;
  assign index[0+:INDEX_BITS]     = index_i;
  assign operand[0+:OPERAND_BITS] = operand_i;
  assign forwarded[0]             = forward && write_index_q == index_i;
  assign depth[0+:DEPTH]     = write_depth_q;

  for (genvar s = 1; s <= STAGES; s++) begin : gen_stages
    logic                    valid_q, forwarded_q;
    logic [INDEX_BITS-1:0]   index_q;
    logic [OPERAND_BITS-1:0] operand_q;
    logic [DEPTH-1:0]   depth_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= 1'b0;
      else         valid_q <= valid[s-1];
    end
    always_ff @(posedge clk_i) begin
      forwarded_q <= forwarded[s-1];
      index_q     <= index[(s-1)*INDEX_BITS+:INDEX_BITS];
      operand_q   <= operand[(s-1)*OPERAND_BITS+:OPERAND_BITS];
      depth_q     <= depth[(s-1)*DEPTH+:DEPTH];
    end

    logic hit;
    assign hit                                   = forward && write_index_q == index_q;
    assign valid[s]                              = valid_q;
    assign forwarded[s]                          = forwarded_q || hit;
    assign index[s*INDEX_BITS+:INDEX_BITS]       = index_q;
    assign operand[s*OPERAND_BITS+:OPERAND_BITS] = operand_q;
    assign depth[s*DEPTH+:DEPTH]       = hit ? write_depth_q : depth_q;
  end

  assign modify_entry_o.present = forwarded[STAGES] || ram_entry_i.present;
  assign modify_entry_o.depth   = forwarded[STAGES] ? depth[STAGES*DEPTH+:DEPTH] : ram_entry_i.depth;
  assign modify_operand_o       = operand[STAGES*OPERAND_BITS+:OPERAND_BITS];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else         write_q <= valid[STAGES] && modify_write_i;
  end
  always_ff @(posedge clk_i) begin
    write_index_q <= index[STAGES*INDEX_BITS+:INDEX_BITS];
    write_depth_q <= modify_depth_i;
  end

  assign write_o       = write_q;
  assign write_index_o = write_index_q;
  assign write_depth_o = write_depth_q;
  assign idle_o        = !write_q && valid[STAGES:1] == '0;

endmodule
