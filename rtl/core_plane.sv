// SPDX-License-Identifier: Apache-2.0
// The depth plane and who reaches it: the projection unit's updates and reads, READ_PLANE, which has read port 0 while it
// lasts, and clears (docs/memory.md). On chip, or in memory behind a cache.

`include "assertions.svh"

module core_plane #(
  parameter int unsigned PLANE_LOG2     = 9,
  parameter bit          EN_PERSPECTIVE = 1'b0,
  parameter int unsigned LATENCY        = 1,   // cycles of a read of the RAM
  parameter int unsigned CACHE_LOG2     = 0,
  parameter int unsigned LINE_IDS_LOG2  = 4,
  parameter int unsigned MEM_STALL_SEED = 0,
  // Derived; not to be overridden.
  parameter int unsigned INDEX = 2 * PLANE_LOG2,
  parameter int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS,
  parameter int unsigned TAG0  = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE)
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  // Updates, and the unit's modify function.
  input  logic                            update_valid_i,
  output logic                            update_ready_o,
  input  logic [INDEX-1:0]                update_index_i,
  input  logic [DEPTH-1:0]                update_operand_i,
  output gnomon_pkg::plane_entry_t        modify_entry_o,
  output logic [DEPTH-1:0]                modify_operand_o,
  input  logic                            modify_write_i,
  input  logic [DEPTH-1:0]                modify_depth_i,
  output logic                            wrote_o,
  // Reads of the projection unit: the voxel's own place, and the offset one.
  input  logic                            read0_valid_i,
  output logic                            read0_ready_o,
  input  logic [INDEX-1:0]                read0_index_i,
  input  logic [TAG0-1:0]                 read0_tag_i,
  output logic                            entry0_valid_o,
  input  logic                            entry0_ready_i,
  output gnomon_pkg::plane_entry_t        entry0_o,
  output logic [TAG0-1:0]                 entry0_tag_o,
  input  logic                            read1_valid_i,
  output logic                            read1_ready_o,
  input  logic [INDEX-1:0]                read1_index_i,
  input  gnomon_pkg::offset_tag_t         read1_tag_i,
  output logic                            entry1_valid_o,
  input  logic                            entry1_ready_i,
  output gnomon_pkg::plane_entry_t        entry1_o,
  output gnomon_pkg::offset_tag_t         entry1_tag_o,
  // READ_PLANE.
  input  logic                            reading_i,      // it owns read port 0
  input  logic                            start_i,
  input  logic [INDEX-1:0]                first_i,
  input  logic [7:0]                      count_minus1_i,
  output logic                            step_o,         // it asked or answered in this cycle
  output logic                            last_o,
  output logic                            busy_o,
  output logic                            result_valid_o,
  input  logic                            result_ready_i,
  output gnomon_pkg::plane_entry_result_t result_o,
  // Clear.
  input  logic                            clear_valid_i,
  output logic                            clear_ready_o,
  output logic                            clear_last_o,
  output logic                            idle_o,
  // Its cache's part of the line port.
  output logic [cache_pkg::WANT-1:0]      want_o,
  input  logic [cache_pkg::GIVE-1:0]      give_i,
  output logic [cache_pkg::EVENTS-1:0]    events_o
);

  localparam int unsigned TAG1 = gnomon_pkg::OFFSET_TAG_BITS;

  // ---- READ_PLANE ----
  logic                            reader_read_valid, reader_read_ready, reader_entry_valid, reader_entry_ready;
  logic [INDEX-1:0]                reader_read_index;
  logic [TAG0-1:0]                 reader_read_tag;
  plane_reader #(.INDEX_BITS(INDEX), .TAG_BITS(TAG0)) u_reader (
    .clk_i, .rst_ni, .start_i, .first_i, .count_minus1_i, .busy_o, .last_o, .read_valid_o(reader_read_valid),
    .read_ready_i(reader_read_ready), .read_index_o(reader_read_index), .read_tag_o(reader_read_tag),
    .entry_valid_i(reader_entry_valid), .entry_ready_o(reader_entry_ready), .entry_i(entry0_o),
    .entry_tag_i(entry0_tag_o), .result_valid_o, .result_ready_i, .result_o
  );
  assign step_o = (reader_read_valid && reader_read_ready) || (result_valid_o && result_ready_i);

  // ---- Read port 0 belongs to READ_PLANE while it lasts, else to the projection unit ----
  logic             read0_valid, read0_ready, entry0_valid, entry0_ready;
  logic [INDEX-1:0] read0_index;
  logic [TAG0-1:0]  read0_tag;
  assign read0_valid        = reading_i ? reader_read_valid : read0_valid_i;
  assign read0_index        = reading_i ? reader_read_index : read0_index_i;
  assign read0_tag          = reading_i ? reader_read_tag : read0_tag_i;
  assign reader_read_ready  = reading_i && read0_ready;
  assign read0_ready_o      = !reading_i && read0_ready;
  assign reader_entry_valid = reading_i && entry0_valid;
  assign entry0_valid_o     = !reading_i && entry0_valid;
  assign entry0_ready       = reading_i ? reader_entry_ready : entry0_ready_i;

  // ---- Plane memory, each of its streams behind a gate for tests ----
  logic update_gated, update_granted, read0_gated, read0_granted, read1_gated, read1_granted;
  logic entry0_given, entry0_taken, entry1_given, entry1_taken;
  localparam bit          STALLS = MEM_STALL_SEED != 0;
  localparam logic [15:0] SEED   = 16'(MEM_STALL_SEED);
  stall_gate #(.SEED(SEED)) u_stall_update (
    .clk_i, .rst_ni, .valid_i(update_valid_i), .ready_o(update_ready_o), .valid_o(update_gated), .ready_i(update_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hA5A5 : 16'd0)) u_stall_read0 (
    .clk_i, .rst_ni, .valid_i(read0_valid), .ready_o(read0_ready), .valid_o(read0_gated), .ready_i(read0_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h3C96 : 16'd0)) u_stall_read1 (
    .clk_i, .rst_ni, .valid_i(read1_valid_i), .ready_o(read1_ready_o), .valid_o(read1_gated), .ready_i(read1_granted)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'h5B1D : 16'd0)) u_stall_entry0 (
    .clk_i, .rst_ni, .valid_i(entry0_given), .ready_o(entry0_taken), .valid_o(entry0_valid), .ready_i(entry0_ready)
  );
  stall_gate #(.SEED(STALLS ? SEED ^ 16'hC2E7 : 16'd0)) u_stall_entry1 (
    .clk_i, .rst_ni, .valid_i(entry1_given), .ready_o(entry1_taken), .valid_o(entry1_valid_o), .ready_i(entry1_ready_i)
  );

  if (CACHE_LOG2 == 0) begin : gen_on_chip
    plane_memory #(
      .INDEX_BITS(INDEX), .OPERAND_BITS(DEPTH), .TAG0_BITS(TAG0), .TAG1_BITS(TAG1), .READ_LATENCY(LATENCY)
    ) u_plane (
      .clk_i, .rst_ni, .update_valid_i(update_gated), .update_ready_o(update_granted), .update_index_i, .update_operand_i,
      .modify_entry_o, .modify_operand_o, .modify_write_i, .modify_depth_i, .wrote_o, .read0_valid_i(read0_gated),
      .read0_ready_o(read0_granted), .read0_index_i(read0_index), .read0_tag_i(read0_tag), .entry0_valid_o(entry0_given),
      .entry0_ready_i(entry0_taken), .entry0_o, .entry0_tag_o, .read1_valid_i(read1_gated), .read1_ready_o(read1_granted),
      .read1_index_i, .read1_tag_i, .entry1_valid_o(entry1_given), .entry1_ready_i(entry1_taken), .entry1_o,
      .entry1_tag_o, .clear_valid_i, .clear_ready_o, .clear_last_o, .idle_o
    );
    logic unused_give;
    assign unused_give = (^give_i) ^ (LINE_IDS_LOG2 == 0);
    assign want_o      = '0;
    assign events_o    = '0;
  end else begin : gen_cached
    plane_cache #(
      .INDEX_BITS(INDEX), .OPERAND_BITS(DEPTH), .TAG0_BITS(TAG0), .TAG1_BITS(TAG1), .SIZE_LOG2(CACHE_LOG2),
      .FIRST_LINE(0), .LINE_IDS_LOG2(LINE_IDS_LOG2)
    ) u_plane (
      .clk_i, .rst_ni, .update_valid_i(update_gated), .update_ready_o(update_granted), .update_index_i, .update_operand_i,
      .modify_entry_o, .modify_operand_o, .modify_write_i, .modify_depth_i, .wrote_o, .read0_valid_i(read0_gated),
      .read0_ready_o(read0_granted), .read0_index_i(read0_index), .read0_tag_i(read0_tag), .entry0_valid_o(entry0_given),
      .entry0_ready_i(entry0_taken), .entry0_o, .entry0_tag_o, .read1_valid_i(read1_gated), .read1_ready_o(read1_granted),
      .read1_index_i, .read1_tag_i, .entry1_valid_o(entry1_given), .entry1_ready_i(entry1_taken), .entry1_o,
      .entry1_tag_o, .clear_valid_i, .clear_ready_o, .idle_o, .want_o, .give_i, .events_o
    );
    assign clear_last_o = 1'b0;
  end

  `GNOMON_ASSERT(a_reader_alone, !busy_o || reading_i)

endmodule
