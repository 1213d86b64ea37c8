// SPDX-License-Identifier: Apache-2.0
// The lines themselves, and the stages that a request goes through without waiting:
//
//   RAM read ─► line in hand: forwarded, replaced by what was filled, modified ─► write register ─► RAM write
//
// A miss reads its victim where a hit reads its line, and writes all banks.

`include "assertions.svh"

module cache_data #(
  parameter int unsigned SLOT_BITS = 9
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // A request is served: x, and a read beside it (y), but not while something is written.
  input  logic                        serve_i,
  input  logic                        x_use_i,      // x has a line
  input  logic                        x_miss_i,
  input  logic [SLOT_BITS-1:0]        x_slot_i,
  input  logic                        y_i,
  input  logic [SLOT_BITS-1:0]        y_slot_i,
  output logic                        writing_o,
  // A cycle later.
  output logic                        valid_o,
  output logic                        miss_o,
  input  logic [cache_pkg::LINE-1:0]  fill_line_i,  // of a miss
  output logic [cache_pkg::LINE-1:0]  x_line_o,
  output logic [cache_pkg::LINE-1:0]  y_line_o,
  output logic [cache_pkg::LINE-1:0]  victim_line_o,
  output logic                        victim_dirty_o,
  input  logic [cache_pkg::BANKS-1:0] write_i,      // the unit writes these banks of x
  input  logic [cache_pkg::LINE-1:0]  write_line_i
);

  localparam int unsigned BANK  = cache_pkg::BANK;
  localparam int unsigned BANKS = cache_pkg::BANKS;
  localparam int unsigned LINE  = cache_pkg::LINE;

  // ---- The request whose line is in hand ----
  logic                 valid_q, use_q, miss_q;
  logic [SLOT_BITS-1:0] x_slot_q, y_slot_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= 1'b0;
    else         valid_q <= serve_i;
  end
  always_ff @(posedge clk_i) begin
    use_q    <= x_use_i;
    miss_q   <= x_miss_i;
    x_slot_q <= x_slot_i;
    y_slot_q <= y_slot_i;
  end
  assign valid_o = valid_q;
  assign miss_o  = valid_q && miss_q;

  // ---- Write register, and what it held a cycle before ----
  logic [BANKS-1:0]     write, write_q, before_q;
  logic [SLOT_BITS-1:0] write_slot_q, before_slot_q;
  logic [LINE-1:0]      write_line_q, before_line_q;
  logic                 any_write, any_write_q;
  assign write       = !(valid_q && use_q) ? '0 : miss_q ? '1 : write_i;
  assign any_write   = write != '0;
  assign any_write_q = write_q != '0;
  assign writing_o   = any_write_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      write_q  <= '0;
      before_q <= '0;
    end else begin
      write_q  <= write;
      before_q <= write_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (any_write) write_slot_q <= x_slot_q;
    if (any_write_q) begin
      before_slot_q <= write_slot_q;
      before_line_q <= write_line_q;
    end
  end

  // ---- Banks ----
  logic             same, same_before, y_same;
  logic [BANKS-1:0] newest, newer, y_newest;
  assign same        = write_slot_q == x_slot_q && !mutations_pkg::NO_FORWARDING;
  assign same_before = before_slot_q == x_slot_q && !mutations_pkg::NO_FORWARDING;
  assign y_same      = write_slot_q == y_slot_q;
  assign newest      = same ? write_q : '0;
  assign newer       = same_before ? before_q : '0;
  assign y_newest    = y_same ? write_q : '0;
  for (genvar b = 0; b < BANKS; b++) begin : gen_banks
    logic [BANK-1:0] x_word, y_word, old_word, x_now;
    plane_bank #(.ADDRESS_BITS(SLOT_BITS), .WIDTH(BANK)) u_bank (
      .clk_i,
      .a_read_i   (serve_i),
      .a_address_i(x_slot_i),
      .a_word_o   (x_word),
      .b_read_i   (serve_i && y_i),
      .b_write_i  (write_q[b]),
      .b_address_i(any_write_q ? write_slot_q : y_slot_i),
      .b_word_i   (write_line_q[b*BANK+:BANK]),
      .b_word_o   (y_word)
    );
    always_comb begin
      if (newest[b])     old_word = write_line_q[b*BANK+:BANK];
      else if (newer[b]) old_word = before_line_q[b*BANK+:BANK];
      else               old_word = x_word;
    end
    assign x_now                         = miss_q ? fill_line_i[b*BANK+:BANK] : old_word;
    assign victim_line_o[b*BANK+:BANK]   = old_word;
    assign x_line_o[b*BANK+:BANK]        = x_now;
    // Nothing was written when y was read, so that only the request before can be newer.
    assign y_line_o[b*BANK+:BANK]        = y_newest[b] ? write_line_q[b*BANK+:BANK] : y_word;
    always_ff @(posedge clk_i) begin
      if (write[b]) write_line_q[b*BANK+:BANK] <= write_i[b] ? write_line_i[b*BANK+:BANK] : x_now;
    end
  end

  // ---- Written since it came? ----
  logic [(1<<SLOT_BITS)-1:0] dirty_q;
  assign victim_dirty_o = dirty_q[x_slot_q];
  always_ff @(posedge clk_i) begin
    if (any_write) dirty_q[x_slot_q] <= write_i != '0 || (!miss_q && dirty_q[x_slot_q]);
  end

  `GNOMON_ASSERT(a_y_reads_while_nothing_is_written, !(serve_i && y_i && writing_o))

endmodule
