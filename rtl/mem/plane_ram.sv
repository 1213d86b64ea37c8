// SPDX-License-Identifier: Apache-2.0
// The plane's storage: 16 banks, one for each slot of a 64-byte line, so that a whole line is cleared in a cycle. Port A
// reads an entry, port B reads or writes one or clears a line. Words come READ_LATENCY cycles after the read.

module plane_ram #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                                   clk_i,
  input  logic                                   a_read_i,
  input  logic [INDEX_BITS-1:0]                  a_index_i,
  output logic [gnomon_pkg::PLANE_WORD_BITS-1:0] a_word_o,
  input  logic                                   b_read_i,
  input  logic                                   b_write_i,
  input  logic                                   b_clear_line_i,
  input  logic [INDEX_BITS-1:0]                  b_index_i,
  input  logic [gnomon_pkg::PLANE_WORD_BITS-1:0] b_word_i,
  output logic [gnomon_pkg::PLANE_WORD_BITS-1:0] b_word_o
);

  localparam int unsigned WORD         = gnomon_pkg::PLANE_WORD_BITS;
  localparam int unsigned SLOT_BITS    = gnomon_pkg::LINE_LOG2;
  localparam int unsigned SLOTS        = 1 << SLOT_BITS;
  localparam int unsigned ADDRESS_BITS = INDEX_BITS - SLOT_BITS;

  logic [ADDRESS_BITS-1:0] a_line, b_line;
  logic [SLOT_BITS-1:0]    a_slot, b_slot, a_slot_q, b_slot_q;
  assign {a_line, a_slot} = a_index_i;
  assign {b_line, b_slot} = b_index_i;

  logic [WORD-1:0] write_word;
  assign write_word = b_clear_line_i ? '0 : b_word_i;

  // A bit a bank.
  logic [SLOTS-1:0] a_reads, b_reads, b_writes;
  always_comb begin
    a_reads  = '0;
    b_reads  = '0;
    b_writes = '0;
    if (a_read_i)       a_reads[a_slot]  = 1'b1;
    if (b_read_i)       b_reads[b_slot]  = 1'b1;
    if (b_write_i)      b_writes[b_slot] = 1'b1;
    if (b_clear_line_i) b_writes         = '1;
  end

  (* mem2reg *) logic [WORD-1:0] a_words [SLOTS];
  (* mem2reg *) logic [WORD-1:0] b_words [SLOTS];
  for (genvar slot = 0; slot < SLOTS; slot++) begin : gen_banks
    logic [WORD-1:0] a_word, b_word;
    plane_bank #(.ADDRESS_BITS(ADDRESS_BITS), .WIDTH(WORD)) u_bank (
      .clk_i,
      .a_read_i   (a_reads[slot]),
      .a_address_i(a_line),
      .a_word_o   (a_word),
      .b_read_i   (b_reads[slot]),
      .b_write_i  (b_writes[slot]),
      .b_address_i(b_line),
      .b_word_i   (write_word),
      .b_word_o   (b_word)
    );
    assign a_words[slot] = a_word;
    assign b_words[slot] = b_word;
  end

  always_ff @(posedge clk_i) begin
    if (a_read_i) a_slot_q <= a_slot;
    if (b_read_i) b_slot_q <= b_slot;
  end

  delay_line #(.WIDTH(WORD), .CYCLES(READ_LATENCY - 1)) u_a_delay (
    .clk_i, .data_i(a_words[a_slot_q]), .data_o(a_word_o)
  );
  delay_line #(.WIDTH(WORD), .CYCLES(READ_LATENCY - 1)) u_b_delay (
    .clk_i, .data_i(b_words[b_slot_q]), .data_o(b_word_o)
  );

endmodule
