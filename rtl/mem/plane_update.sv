// SPDX-License-Identifier: Apache-2.0
// Update port of a memory: read a word, let the unit modify it, write it back; one update a cycle, in order, whatever
// words they hit. Writes that are still on their way are forwarded to the updates behind them:
//
//   take ─► RAM read, READ_LATENCY cycles ─► modify ─► write register ─► RAM write
//             ▲ every stage watches the write register, and keeps what goes to its own word

module plane_update #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned OPERAND_BITS = 24,
  parameter int unsigned WORD_BITS    = 25,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // Updates; always taken.
  input  logic                    valid_i,
  input  logic [INDEX_BITS-1:0]   index_i,
  input  logic [OPERAND_BITS-1:0] operand_i,
  // The RAM's answer to the read of `index_i`, READ_LATENCY cycles later.
  input  logic [WORD_BITS-1:0]    ram_word_i,
  // The unit's modify function, combinational.
  output logic                    modify_valid_o,
  output logic [INDEX_BITS-1:0]   modify_index_o,
  output logic [WORD_BITS-1:0]    modify_word_o,
  output logic [OPERAND_BITS-1:0] modify_operand_o,
  input  logic                    modify_write_i,
  input  logic [WORD_BITS-1:0]    modify_word_i,
  // Write back.
  output logic                    write_o,
  output logic [INDEX_BITS-1:0]   write_index_o,
  output logic [WORD_BITS-1:0]    write_word_o,
  // Nothing on its way: every update taken is in the RAM.
  output logic                    idle_o
);

  localparam int unsigned STAGES = READ_LATENCY;

  logic                  write_q;
  logic [INDEX_BITS-1:0] write_index_q;
  logic [WORD_BITS-1:0]  write_word_q;

  // Slice s is what stage s works on: 0 is the update being taken, STAGES the one being modified.
  logic [STAGES:0]                    valid, forwarded;
  logic [(STAGES+1)*INDEX_BITS-1:0]   index;
  logic [(STAGES+1)*OPERAND_BITS-1:0] operand;
  logic [(STAGES+1)*WORD_BITS-1:0]    word;  // where forwarded

  logic forward;
  assign forward = write_q && !mutations_pkg::NO_FORWARDING;

  assign valid[0]                 = valid_i;
  assign index[0+:INDEX_BITS]     = index_i;
  assign operand[0+:OPERAND_BITS] = operand_i;
  assign forwarded[0]             = forward && write_index_q == index_i;
  assign word[0+:WORD_BITS]       = write_word_q;

  for (genvar s = 1; s <= STAGES; s++) begin : gen_stages
    logic                    valid_q, forwarded_q;
    logic [INDEX_BITS-1:0]   index_q;
    logic [OPERAND_BITS-1:0] operand_q;
    logic [WORD_BITS-1:0]    word_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) valid_q <= 1'b0;
      else         valid_q <= valid[s-1];
    end
    always_ff @(posedge clk_i) begin
      if (valid[s-1]) begin
        forwarded_q <= forwarded[s-1];
        index_q     <= index[(s-1)*INDEX_BITS+:INDEX_BITS];
        operand_q   <= operand[(s-1)*OPERAND_BITS+:OPERAND_BITS];
        if (forwarded[s-1]) word_q <= word[(s-1)*WORD_BITS+:WORD_BITS];
      end
    end

    logic hit;
    assign hit                                   = forward && write_index_q == index_q;
    assign valid[s]                              = valid_q;
    assign forwarded[s]                          = forwarded_q || hit;
    assign index[s*INDEX_BITS+:INDEX_BITS]       = index_q;
    assign operand[s*OPERAND_BITS+:OPERAND_BITS] = operand_q;
    assign word[s*WORD_BITS+:WORD_BITS]          = hit ? write_word_q : word_q;
  end

  assign modify_valid_o   = valid[STAGES];
  assign modify_index_o   = index[STAGES*INDEX_BITS+:INDEX_BITS];
  assign modify_word_o    = forwarded[STAGES] ? word[STAGES*WORD_BITS+:WORD_BITS] : ram_word_i;
  assign modify_operand_o = operand[STAGES*OPERAND_BITS+:OPERAND_BITS];

  always_ff @(posedge clk_i) begin
    if (!rst_ni) write_q <= 1'b0;
    else         write_q <= modify_valid_o && modify_write_i;
  end
  always_ff @(posedge clk_i) begin
    if (modify_valid_o) begin
      write_index_q <= modify_index_o;
      if (modify_write_i) write_word_q <= modify_word_i;
    end
  end

  assign write_o       = write_q;
  assign write_index_o = write_index_q;
  assign write_word_o  = write_word_q;
  assign idle_o        = !write_q && valid[STAGES:1] == '0;

endmodule
