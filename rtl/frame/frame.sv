// SPDX-License-Identifier: Apache-2.0
// Cubic frame buffer: keeps the states of a grid of voxels, a layer a light, and gives them back when asked
// (docs/frame-buffer.md has the definition). One state kept and one looked up a cycle.

`include "assertions.svh"

module frame #(
  parameter int unsigned VOXEL_BITS      = 8,
  parameter int unsigned VOXEL_FRAC_BITS = 2,
  parameter int unsigned LAYERS_LOG2     = 0,
  parameter int unsigned QUEUE_LOG2      = 6,   // voxels that a resolve pass may hold
  parameter int unsigned MEM_LATENCY     = 1,
  parameter int unsigned MEM_STALL_SEED  = 0
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // A good command of this unit, or one that resolves voxels, begins with header `word_i`; its items follow as `word_i`.
  // Another kind of command begins only while the unit is idle.
  input  logic                     start_i,
  input  logic [63:0]              word_i,
  // Items of LOOKUP_FRAME.
  input  logic                     item_valid_i,
  output logic                     item_ready_o,
  input  logic                     item_last_i,     // of its command
  // Items that a resolve pass takes; only while there is room.
  input  logic                     voxel_valid_i,
  output logic                     voxel_ready_o,
  // State words of the pass, in order, and other words, on their way to the results.
  input  logic                     state_valid_i,
  output logic                     state_ready_o,
  input  logic [1:0]               state_i,
  output logic                     told_valid_o,
  input  logic                     told_ready_i,
  // FRAME_STATES words.
  output logic                     result_valid_o,
  input  logic                     result_ready_i,
  output frame_pkg::frame_states_t result_o,
  output logic                     idle_o,          // without another word nothing more happens
  output logic                     step_o,          // a line is scrubbed or a word of states given
  output logic                     wait_o,          // the memory holds something back
  output frame_pkg::frame_events_t events_o
);

  localparam int unsigned INDEX = frame_pkg::index_bits(VOXEL_BITS, LAYERS_LOG2);
  localparam int unsigned BRICK = frame_pkg::BRICK_BITS;

  // ---- The command in progress. Its layer is taken once: the decoder counts items up in its copy of the header ----
  gnomon_pkg::header_t              header;
  logic                             clear, keep_q, quiet_q, brick_q, unused_header;
  logic [frame_pkg::LAYER_BITS-1:0] layer_q;
  assign header        = word_i;
  assign clear         = start_i && header.op == gnomon_pkg::OP_CLEAR_FRAME;
  assign unused_header = ^header;
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      keep_q  <= gnomon_pkg::is_resolve_op(header.op) && (header.flags & gnomon_pkg::RESOLVE_KEEP) != '0;
      quiet_q <= gnomon_pkg::is_resolve_op(header.op) && (header.flags & gnomon_pkg::RESOLVE_QUIET) != '0;
      brick_q <= (header.flags & gnomon_pkg::LOOKUP_BRICK) != '0;
      layer_q <= (mutations_pkg::FRAME_LAYER_ZERO && header.op != gnomon_pkg::OP_LOOKUP_FRAME)
                   ? '0 : header.arg[31-:frame_pkg::LAYER_BITS];
    end
  end

  logic [INDEX-1:0]                 index;
  logic [frame_pkg::PLACE_BITS-1:0] place;
  frame_place #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .LAYERS_LOG2(LAYERS_LOG2)
  ) u_place (.item_i(word_i), .layer_i(layer_q), .index_o(index), .place_o(place));

  // ---- States of a resolve pass ----
  logic                update_valid, update_ready, keep_idle;
  logic [INDEX-1:0]    update_index;
  frame_pkg::operand_t update_operand;
  frame_keep #(.INDEX_BITS(INDEX), .QUEUE_LOG2(QUEUE_LOG2)) u_keep (
    .clk_i, .rst_ni, .voxel_valid_i, .voxel_ready_o, .index_i(index), .place_i(place), .keep_i(keep_q),
    .quiet_i(quiet_q), .state_valid_i, .state_ready_o, .state_i, .told_valid_o, .told_ready_i,
    .update_valid_o(update_valid), .update_ready_i(update_ready), .update_index_o(update_index),
    .update_operand_o(update_operand), .idle_o(keep_idle)
  );

  // ---- Memory ----
  logic                          modify_valid, modify_present, overwritten, entry_valid, entry_ready, entry_present;
  logic                          scrubbing, memory_idle;
  logic [BRICK-1:0]              modify_brick, new_brick, entry;
  frame_pkg::operand_t           modify_operand;
  frame_pkg::tag_t               read_tag, entry_tag;
  assign read_tag.last  = item_last_i;
  assign read_tag.brick = brick_q;
  assign read_tag.place = place;
  frame_modify u_modify (
    .present_i(modify_present), .brick_i(modify_brick), .operand_i(modify_operand), .brick_o(new_brick),
    .overwritten_o(overwritten)
  );
  entry_memory #(
    .INDEX_BITS(INDEX), .ENTRY_BITS(BRICK), .OPERAND_BITS(frame_pkg::OPERAND_BITS), .TAG_BITS(frame_pkg::TAG_BITS),
    .READ_LATENCY(MEM_LATENCY), .STALL_SEED((MEM_STALL_SEED == 0) ? 0 : MEM_STALL_SEED ^ 32'h71C8)
  ) u_memory (
    .clk_i, .rst_ni, .update_valid_i(update_valid), .update_ready_o(update_ready), .update_index_i(update_index),
    .update_operand_i(update_operand), .modify_valid_o(modify_valid), .modify_present_o(modify_present),
    .modify_entry_o(modify_brick), .modify_operand_o(modify_operand), .modify_entry_i(new_brick),
    .read_valid_i(item_valid_i), .read_ready_o(item_ready_o), .read_index_i(index), .read_tag_i(read_tag),
    .entry_valid_o(entry_valid), .entry_ready_i(entry_ready), .entry_present_o(entry_present), .entry_o(entry),
    .entry_tag_o(entry_tag), .clear_i(clear), .scrubbing_o(scrubbing), .idle_o(memory_idle)
  );

  // ---- Lookups ----
  frame_lookup u_lookup (
    .clk_i, .rst_ni, .entry_valid_i(entry_valid), .entry_ready_o(entry_ready), .present_i(entry_present),
    .brick_i(entry), .tag_i(entry_tag), .result_valid_o, .result_ready_i, .result_o, .lookup_o(events_o.lookup),
    .lookup_empty_o(events_o.lookup_empty), .brick_o(events_o.brick)
  );

  assign events_o.kept        = modify_valid;
  assign events_o.overwritten = modify_valid && overwritten;

  assign idle_o = keep_idle && memory_idle;
  assign step_o = scrubbing || (result_valid_o && result_ready_i);
  assign wait_o = (update_valid && !update_ready) || (item_valid_i && !item_ready_o);

  `GNOMON_ASSERT(a_one_user, !(voxel_valid_i && item_valid_i))
  `GNOMON_ASSERT(a_clear_alone, !clear || idle_o)

endmodule
