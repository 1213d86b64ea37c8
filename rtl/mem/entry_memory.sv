// SPDX-License-Identifier: Apache-2.0
// Memory of entries that a clear makes absent: update port, read port and clear, latency-insensitive; tags of generations,
// forwarding and scrubbing as in the plane memory (docs/memory.md). Holds list heads and the bricks of the frame buffer.

`include "assertions.svh"

module entry_memory #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned ENTRY_BITS   = 42,
  parameter int unsigned OPERAND_BITS = 59,
  parameter int unsigned TAG_BITS     = 49,
  parameter int unsigned READ_LATENCY = 1,
  parameter int unsigned STALL_SEED   = 0
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // Update port and the unit's combinational modify function; every update writes its entry, which makes it present.
  input  logic                    update_valid_i,
  output logic                    update_ready_o,
  input  logic [INDEX_BITS-1:0]   update_index_i,
  input  logic [OPERAND_BITS-1:0] update_operand_i,
  output logic                    modify_valid_o,
  output logic                    modify_present_o,
  output logic [ENTRY_BITS-1:0]   modify_entry_o,
  output logic [OPERAND_BITS-1:0] modify_operand_o,
  input  logic [ENTRY_BITS-1:0]   modify_entry_i,
  // Read port.
  input  logic                    read_valid_i,
  output logic                    read_ready_o,
  input  logic [INDEX_BITS-1:0]   read_index_i,
  input  logic [TAG_BITS-1:0]     read_tag_i,
  output logic                    entry_valid_o,
  input  logic                    entry_ready_i,
  output logic                    entry_present_o,
  output logic [ENTRY_BITS-1:0]   entry_o,
  output logic [TAG_BITS-1:0]     entry_tag_o,
  // Clear; only while idle.
  input  logic                    clear_i,
  output logic                    scrubbing_o,
  output logic                    idle_o
);

  localparam int unsigned SLOT_BITS = gnomon_pkg::LINE_LOG2;
  localparam int unsigned SLOTS     = 1 << SLOT_BITS;
  localparam int unsigned LINE_BITS = INDEX_BITS - SLOT_BITS;
  localparam int unsigned TAG       = gnomon_pkg::GENERATION_BITS;
  localparam int unsigned WORD      = TAG + ENTRY_BITS;

  localparam bit          STALLS = STALL_SEED != 0;
  localparam logic [15:0] SEED   = 16'(STALL_SEED);

  // ---- Gates for tests ----
  logic update_gated, update_granted, read_gated, read_granted, entry_given, entry_taken;
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h1F35 : 16'd0)) u_stall_update (
    .clk_i, .rst_ni, .valid_i(update_valid_i), .ready_o(update_ready_o), .valid_o(update_gated),
    .ready_i(update_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h60D2 : 16'd0)) u_stall_read (
    .clk_i, .rst_ni, .valid_i(read_valid_i), .ready_o(read_ready_o), .valid_o(read_gated), .ready_i(read_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hB94C : 16'd0)) u_stall_entry (
    .clk_i, .rst_ni, .valid_i(entry_given), .ready_o(entry_taken), .valid_o(entry_valid_o), .ready_i(entry_ready_i)
  );

  // ---- Generation and scrubbing ----
  logic                 scrub_last;
  logic [LINE_BITS-1:0] scrub_line;
  logic [TAG-1:0]       generation;
  plane_clear #(.LINE_ADDRESS_BITS(LINE_BITS)) u_clear (
    .clk_i, .rst_ni, .clear_i, .scrubbing_o, .last_o(scrub_last), .line_o(scrub_line), .generation_o(generation)
  );

  // ---- Banks: one for each slot of a line, so that a line is scrubbed in a cycle ----
  logic                  update_take, read, write;
  logic [INDEX_BITS-1:0] read_index, write_index;
  logic [LINE_BITS-1:0]  a_line, b_line, write_line;
  logic [SLOT_BITS-1:0]  a_slot, a_slot_q, b_slot;
  logic [ENTRY_BITS:0]    write_word;  // {present, entry}
  assign update_granted       = !scrubbing_o;
  assign update_take          = update_gated && update_granted;
  assign {a_line, a_slot}     = update_take ? update_index_i : read_index;
  assign {write_line, b_slot} = write_index;
  assign b_line               = scrubbing_o ? scrub_line : write_line;

  logic [SLOTS*WORD-1:0] words;
  for (genvar slot = 0; slot < SLOTS; slot++) begin : gen_banks
    logic [WORD-1:0] unused_word;
    plane_bank #(.ADDRESS_BITS(LINE_BITS), .WIDTH(WORD)) u_bank (
      .clk_i,
      .a_read_i   ((update_take || read) && a_slot == SLOT_BITS'(slot)),
      .a_address_i(a_line),
      .a_word_o   (words[slot*WORD+:WORD]),
      .b_read_i   (1'b0),
      .b_write_i  (scrubbing_o || (write && b_slot == SLOT_BITS'(slot))),
      .b_address_i(b_line),
      .b_word_i   (scrubbing_o ? '0 : {generation, write_word[ENTRY_BITS-1:0]}),
      .b_word_o   (unused_word)
    );
  end
  always_ff @(posedge clk_i) begin
    if (update_take || read) a_slot_q <= a_slot;
  end

  logic [WORD-1:0]    word;
  logic [ENTRY_BITS:0] stored;  // {present, entry}
  delay_line #(.WIDTH(WORD), .CYCLES(READ_LATENCY - 1)) u_delay (
    .clk_i, .data_i(words[a_slot_q*WORD+:WORD]), .data_o(word)
  );
  assign stored = {word[ENTRY_BITS+:TAG] == generation, word[ENTRY_BITS-1:0]};

  // ---- Ports ----
  logic                  update_idle, read_idle, unused_modify;
  logic [INDEX_BITS-1:0] modify_index;
  plane_update #(
    .INDEX_BITS(INDEX_BITS), .OPERAND_BITS(OPERAND_BITS), .WORD_BITS(ENTRY_BITS + 1), .READ_LATENCY(READ_LATENCY)
  ) u_update (
    .clk_i, .rst_ni, .valid_i(update_take), .index_i(update_index_i), .operand_i(update_operand_i),
    .ram_word_i(stored), .modify_valid_o, .modify_index_o(modify_index),
    .modify_word_o({modify_present_o, modify_entry_o}), .modify_operand_o, .modify_write_i(1'b1),
    .modify_word_i({1'b1, modify_entry_i}), .write_o(write), .write_index_o(write_index), .write_word_o(write_word),
    .idle_o(update_idle)
  );
  plane_read_port #(
    .INDEX_BITS(INDEX_BITS), .TAG_BITS(TAG_BITS), .ENTRY_BITS(ENTRY_BITS + 1), .READ_LATENCY(READ_LATENCY)
  ) u_read (
    .clk_i, .rst_ni, .request_valid_i(read_gated), .request_ready_o(read_granted), .request_index_i(read_index_i),
    .request_tag_i(read_tag_i), .ram_free_i(!scrubbing_o && !update_gated), .ram_read_o(read),
    .ram_index_o(read_index), .ram_entry_i(stored), .response_valid_o(entry_given), .response_ready_i(entry_taken),
    .response_entry_o({entry_present_o, entry_o}), .response_tag_o(entry_tag_o), .idle_o(read_idle)
  );

  assign idle_o        = !scrubbing_o && update_idle && read_idle;
  assign unused_modify = scrub_last ^ (^modify_index) ^ write_word[ENTRY_BITS];

  `GNOMON_ASSERT(a_clear_while_idle, !clear_i || (idle_o && !update_valid_i && !read_valid_i))
  `GNOMON_ASSERT(a_write_outside_scrub, !(write && scrubbing_o))

endmodule
