// SPDX-License-Identifier: Apache-2.0
// Plane memory on the chip: an update port, two read ports and the clear, all latency-insensitive. Generation tags,
// forwarding and scrubbing stay in here; units see entries that are present or not (docs/memory.md).

`include "assertions.svh"

module plane_memory #(
  parameter int unsigned INDEX_BITS   = 18,
  parameter int unsigned OPERAND_BITS = 24,
  parameter int unsigned TAG0_BITS    = 24,
  parameter int unsigned TAG1_BITS    = 24,
  parameter int unsigned READ_LATENCY = 1
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // Update port and the unit's combinational modify function.
  input  logic                     update_valid_i,
  output logic                     update_ready_o,
  input  logic [INDEX_BITS-1:0]    update_index_i,
  input  logic [OPERAND_BITS-1:0]  update_operand_i,
  output gnomon_pkg::plane_entry_t modify_entry_o,
  output logic [OPERAND_BITS-1:0]  modify_operand_o,
  input  logic                     modify_write_i,
  input  logic [gnomon_pkg::DEPTH_FIELD_BITS-1:0] modify_depth_i,    // makes the entry present
  output logic                     wrote_o,           // event: an update changed its entry
  // Read port 0.
  input  logic                     read0_valid_i,
  output logic                     read0_ready_o,
  input  logic [INDEX_BITS-1:0]    read0_index_i,
  input  logic [TAG0_BITS-1:0]     read0_tag_i,
  output logic                     entry0_valid_o,
  input  logic                     entry0_ready_i,
  output gnomon_pkg::plane_entry_t entry0_o,
  output logic [TAG0_BITS-1:0]     entry0_tag_o,
  // Read port 1.
  input  logic                     read1_valid_i,
  output logic                     read1_ready_o,
  input  logic [INDEX_BITS-1:0]    read1_index_i,
  input  logic [TAG1_BITS-1:0]     read1_tag_i,
  output logic                     entry1_valid_o,
  input  logic                     entry1_ready_i,
  output gnomon_pkg::plane_entry_t entry1_o,
  output logic [TAG1_BITS-1:0]     entry1_tag_o,
  // Clear: taken when everything before it is done; the last step is announced.
  input  logic                     clear_valid_i,
  output logic                     clear_ready_o,
  output logic                     clear_last_o,
  // Fence: no update or read under way, no scrubbing. What was written is what is read.
  output logic                     idle_o
);

  localparam int unsigned WORD      = gnomon_pkg::PLANE_WORD_BITS;
  localparam int unsigned TAG       = gnomon_pkg::GENERATION_BITS;
  localparam int unsigned DEPTH     = gnomon_pkg::DEPTH_FIELD_BITS;
  localparam int unsigned SLOT_BITS = gnomon_pkg::LINE_LOG2;
  localparam int unsigned ENTRY     = DEPTH + 1;  // plane_entry_t

  logic                            scrubbing;
  logic [INDEX_BITS-SLOT_BITS-1:0] scrub_line;
  logic [TAG-1:0]                  generation;
  plane_clear #(.LINE_ADDRESS_BITS(INDEX_BITS - SLOT_BITS)) u_clear (
    .clk_i,
    .rst_ni,
    .clear_i     (clear_valid_i && clear_ready_o),
    .scrubbing_o (scrubbing),
    .last_o      (clear_last_o),
    .line_o      (scrub_line),
    .generation_o(generation)
  );

  // Port A reads for updates first, then for read port 0; port B writes back or scrubs first, then reads for port 1.
  logic [WORD-1:0]          a_word, b_word;
  gnomon_pkg::plane_entry_t a_entry, b_entry;
  gnomon_pkg::plane_entry_t new_entry, write_entry;
  logic                     update_take, write, read0, read1, update_idle, read0_idle, read1_idle;
  logic [INDEX_BITS-1:0]    write_index, read0_index, read1_index, b_index;

  assign update_ready_o = !scrubbing;
  assign update_take    = update_valid_i && update_ready_o;
  always_comb begin
    if (scrubbing)  b_index = {scrub_line, SLOT_BITS'(0)};
    else if (write) b_index = write_index;
    else            b_index = read1_index;
  end

  plane_ram #(.INDEX_BITS(INDEX_BITS), .READ_LATENCY(READ_LATENCY)) u_ram (
    .clk_i,
    .a_read_i      (update_take || read0),
    .a_index_i     (update_take ? update_index_i : read0_index),
    .a_word_o      (a_word),
    .b_read_i      (read1),
    .b_write_i     (write),
    .b_clear_line_i(scrubbing),
    .b_index_i     (b_index),
    .b_word_i      ({generation, write_entry.depth}),
    .b_word_o      (b_word)
  );

  // The generation changes only while nothing is under way, so that the tag can be judged when the word arrives.
  assign a_entry.present = a_word[DEPTH+:TAG] == generation;
  assign a_entry.depth   = a_word[DEPTH-1:0];
  assign b_entry.present = b_word[DEPTH+:TAG] == generation;
  assign b_entry.depth   = b_word[DEPTH-1:0];

  // What an update writes is present.
  logic                  modify_valid, unused_update;
  logic [INDEX_BITS-1:0] modify_index;
  assign new_entry.present = 1'b1;
  assign new_entry.depth   = modify_depth_i;
  plane_update #(
    .INDEX_BITS(INDEX_BITS), .OPERAND_BITS(OPERAND_BITS), .WORD_BITS(ENTRY), .READ_LATENCY(READ_LATENCY)
  ) u_update (
    .clk_i,
    .rst_ni,
    .valid_i         (update_take),
    .index_i         (update_index_i),
    .operand_i       (update_operand_i),
    .ram_word_i      (a_entry),
    .modify_valid_o  (modify_valid),
    .modify_index_o  (modify_index),
    .modify_word_o   (modify_entry_o),
    .modify_operand_o,
    .modify_write_i,
    .modify_word_i   (new_entry),
    .write_o         (write),
    .write_index_o   (write_index),
    .write_word_o    (write_entry),
    .idle_o          (update_idle)
  );
  assign wrote_o       = write;
  assign unused_update = modify_valid ^ (^modify_index) ^ write_entry.present;

  plane_read_port #(
    .INDEX_BITS(INDEX_BITS), .TAG_BITS(TAG0_BITS), .ENTRY_BITS(ENTRY), .READ_LATENCY(READ_LATENCY)
  ) u_read0 (
    .clk_i,
    .rst_ni,
    .request_valid_i (read0_valid_i),
    .request_ready_o (read0_ready_o),
    .request_index_i (read0_index_i),
    .request_tag_i   (read0_tag_i),
    .ram_free_i      (!scrubbing && !update_valid_i),
    .ram_read_o      (read0),
    .ram_index_o     (read0_index),
    .ram_entry_i     (a_entry),
    .response_valid_o(entry0_valid_o),
    .response_ready_i(entry0_ready_i),
    .response_entry_o(entry0_o),
    .response_tag_o  (entry0_tag_o),
    .idle_o          (read0_idle)
  );

  plane_read_port #(
    .INDEX_BITS(INDEX_BITS), .TAG_BITS(TAG1_BITS), .ENTRY_BITS(ENTRY), .READ_LATENCY(READ_LATENCY)
  ) u_read1 (
    .clk_i,
    .rst_ni,
    .request_valid_i (read1_valid_i),
    .request_ready_o (read1_ready_o),
    .request_index_i (read1_index_i),
    .request_tag_i   (read1_tag_i),
    .ram_free_i      (!scrubbing && !write),
    .ram_read_o      (read1),
    .ram_index_o     (read1_index),
    .ram_entry_i     (b_entry),
    .response_valid_o(entry1_valid_o),
    .response_ready_i(entry1_ready_i),
    .response_entry_o(entry1_o),
    .response_tag_o  (entry1_tag_o),
    .idle_o          (read1_idle)
  );

  assign idle_o        = !scrubbing && update_idle && read0_idle && read1_idle;
  assign clear_ready_o = idle_o && !update_valid_i && !read0_valid_i && !read1_valid_i;

  `GNOMON_ASSERT(a_write_outside_scrub, !(write && scrubbing))

endmodule
