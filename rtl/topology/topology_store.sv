// SPDX-License-Identifier: Apache-2.0
// Memory of nodes or of quad records: a write port and a read port, both latency-insensitive. Reads see every write
// taken in an earlier cycle.

module topology_store #(
  parameter int unsigned INDEX_BITS   = 20,
  parameter int unsigned WORD_BITS    = 59,
  parameter int unsigned TAG_BITS     = 30,
  parameter int unsigned READ_LATENCY = 1,
  parameter int unsigned STALL_SEED   = 0
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  write_valid_i,
  output logic                  write_ready_o,
  input  logic [INDEX_BITS-1:0] write_index_i,
  input  logic [WORD_BITS-1:0]  write_word_i,
  input  logic                  read_valid_i,
  output logic                  read_ready_o,
  input  logic [INDEX_BITS-1:0] read_index_i,
  input  logic [TAG_BITS-1:0]   read_tag_i,
  output logic                  word_valid_o,
  input  logic                  word_ready_i,
  output logic [WORD_BITS-1:0]  word_o,
  output logic [TAG_BITS-1:0]   word_tag_o,
  output logic                  idle_o          // no read under way
);

  localparam bit          STALLS = STALL_SEED != 0;
  localparam logic [15:0] SEED   = 16'(STALL_SEED);

  // ---- Gates for tests ----
  logic write, read_gated, read_granted, word_given, word_taken;
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h4AC1 : 16'd0)) u_stall_write (
    .clk_i, .rst_ni, .valid_i(write_valid_i), .ready_o(write_ready_o), .valid_o(write), .ready_i(1'b1)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h8739 : 16'd0)) u_stall_read (
    .clk_i, .rst_ni, .valid_i(read_valid_i), .ready_o(read_ready_o), .valid_o(read_gated), .ready_i(read_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hE25E : 16'd0)) u_stall_word (
    .clk_i, .rst_ni, .valid_i(word_given), .ready_o(word_taken), .valid_o(word_valid_o), .ready_i(word_ready_i)
  );

  logic                  read;
  logic [INDEX_BITS-1:0] read_index;
  logic [WORD_BITS-1:0]  ram_word, word, unused_word;
  plane_bank #(.ADDRESS_BITS(INDEX_BITS), .WIDTH(WORD_BITS)) u_ram (
    .clk_i, .a_read_i(read), .a_address_i(read_index), .a_word_o(ram_word), .b_read_i(1'b0), .b_write_i(write),
    .b_address_i(write_index_i), .b_word_i(write_word_i), .b_word_o(unused_word)
  );
  delay_line #(.WIDTH(WORD_BITS), .CYCLES(READ_LATENCY - 1)) u_delay (.clk_i, .data_i(ram_word), .data_o(word));

  plane_read_port #(
    .INDEX_BITS(INDEX_BITS), .TAG_BITS(TAG_BITS), .ENTRY_BITS(WORD_BITS), .READ_LATENCY(READ_LATENCY)
  ) u_read (
    .clk_i, .rst_ni, .request_valid_i(read_gated), .request_ready_o(read_granted), .request_index_i(read_index_i),
    .request_tag_i(read_tag_i), .ram_free_i(1'b1), .ram_read_o(read), .ram_index_o(read_index), .ram_entry_i(word),
    .response_valid_o(word_given), .response_ready_i(word_taken), .response_entry_o(word_o),
    .response_tag_o(word_tag_o), .idle_o
  );

endmodule
