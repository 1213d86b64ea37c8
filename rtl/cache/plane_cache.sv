// SPDX-License-Identifier: Apache-2.0
// The plane in memory behind a cache: the ports of plane_memory, which see no difference but time (docs/cache.md). An entry
// is 32 bits, {present, depth}; a line is a tile of 4 x 4 entries, tiles lie in Morton order.

`include "assertions.svh"

module plane_cache #(
  parameter int unsigned INDEX_BITS    = 18,
  parameter int unsigned OPERAND_BITS  = 24,
  parameter int unsigned TAG0_BITS     = 24,
  parameter int unsigned TAG1_BITS     = 24,
  parameter int unsigned SIZE_LOG2     = 15,
  parameter int unsigned FIRST_LINE    = 0,
  parameter int unsigned LINE_IDS_LOG2 = 4
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
  // Clear: taken when everything before it is done.
  input  logic                     clear_valid_i,
  output logic                     clear_ready_o,
  // Fence: no update or read under way, no scrubbing. What was written is what is read.
  output logic                     idle_o,
  // Line port.
  output cache_pkg::want_t         want_o,
  input  cache_pkg::give_t         give_i,
  output cache_pkg::events_t       events_o
);

  localparam int unsigned P         = INDEX_BITS / 2;
  localparam int unsigned PLACE     = 4;                   // of an entry in its line
  localparam int unsigned LINE_BITS = INDEX_BITS - PLACE;
  localparam int unsigned BANK      = cache_pkg::BANK;
  localparam int unsigned DEPTH     = gnomon_pkg::DEPTH_FIELD_BITS;
  localparam int unsigned ENTRY     = DEPTH + 1;           // plane_entry_t
  localparam int unsigned PAYLOAD   = gnomon_pkg::max_of(gnomon_pkg::max_of(OPERAND_BITS, TAG0_BITS), TAG1_BITS);

  localparam logic [1:0] KIND_UPDATE = 2'd0;
  localparam logic [1:0] KIND_READ0  = 2'd1;
  localparam logic [1:0] KIND_READ1  = 2'd2;

  // ---- Requests: updates first; reads of both ports together, where both hit ----
  logic                  x_ready, y_ready, y_valid;
  logic [1:0]            x_kind;
  logic [INDEX_BITS-1:0] x_index;
  logic [PAYLOAD-1:0]    x_payload;
  always_comb begin
    if (update_valid_i) begin
      x_kind    = KIND_UPDATE;
      x_index   = update_index_i;
      x_payload = PAYLOAD'(update_operand_i);
    end else if (read0_valid_i) begin
      x_kind    = KIND_READ0;
      x_index   = read0_index_i;
      x_payload = PAYLOAD'(read0_tag_i);
    end else begin
      x_kind    = KIND_READ1;
      x_index   = read1_index_i;
      x_payload = PAYLOAD'(read1_tag_i);
    end
  end
  assign y_valid        = x_kind == KIND_READ0 && read1_valid_i;
  assign update_ready_o = x_ready;
  assign read0_ready_o  = x_ready && !update_valid_i;
  always_comb begin
    if (update_valid_i)     read1_ready_o = 1'b0;
    else if (read0_valid_i) read1_ready_o = y_ready;
    else                    read1_ready_o = x_ready;
  end

  // ---- Places in lines ----
  logic [LINE_BITS-1:0] x_line, y_line;
  logic [PLACE-1:0]     x_place, y_place;
  assign x_place = {x_index[P+:2], x_index[1:0]};
  assign y_place = {read1_index_i[P+:2], read1_index_i[1:0]};
  for (genvar i = 0; i < P - 2; i++) begin : gen_morton
    assign x_line[2*i]   = x_index[2+i];
    assign x_line[2*i+1] = x_index[P+2+i];
    assign y_line[2*i]   = read1_index_i[2+i];
    assign y_line[2*i+1] = read1_index_i[P+2+i];
  end

  // ---- The cache ----
  logic                        first, first_y, serve, hand, hand_y, cache_idle, cache_clear_ready;
  logic [2+PLACE+PAYLOAD-1:0]  first_info, hand_info;
  logic [PLACE+TAG1_BITS-1:0]  hand_y_info;
  logic [cache_pkg::LINE-1:0]  x_line_data, y_line_data;
  logic [cache_pkg::BANKS-1:0] write;
  line_cache #(
    .LINE_BITS(LINE_BITS), .SIZE_LOG2(SIZE_LOG2), .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .X_BITS(2 + PLACE + PAYLOAD), .Y_BITS(PLACE + TAG1_BITS)
  ) u_cache (
    .clk_i, .rst_ni, .x_valid_i(update_valid_i || read0_valid_i || read1_valid_i), .x_ready_o(x_ready),
    .x_use_i(1'b1), .x_line_i(x_line), .x_info_i({x_kind, x_place, x_payload}), .y_valid_i(y_valid),
    .y_ready_o(y_ready), .y_line_i(y_line), .y_info_i({y_place, read1_tag_i}), .first_valid_o(first),
    .first_x_info_o(first_info), .first_y_o(first_y), .serve_i(serve), .hand_valid_o(hand), .x_info_o(hand_info),
    .x_line_o(x_line_data), .y_o(hand_y), .y_info_o(hand_y_info), .y_line_o(y_line_data), .write_i(write),
    .write_line_i({cache_pkg::BANKS{new_word}}), .clear_i(clear_valid_i && clear_ready_o),
    .clear_ready_o(cache_clear_ready), .idle_o(cache_idle), .want_o, .give_i, .events_o
  );

  // ---- The request in hand ----
  logic [1:0]         kind;
  logic [PLACE-1:0]   place;
  logic [PAYLOAD-1:0] payload;
  logic [PLACE-1:0]   place_beside;
  logic [TAG1_BITS-1:0] tag_beside;
  logic [BANK-1:0]    word, word_beside, new_word;
  logic               update, unused_bits;
  gnomon_pkg::plane_entry_t entry, entry_beside;
  assign {kind, place, payload}     = hand_info;
  assign {place_beside, tag_beside} = hand_y_info;
  assign word                 = x_line_data[place*BANK+:BANK];
  assign word_beside          = y_line_data[place_beside*BANK+:BANK];
  assign entry.present        = word[BANK-1];
  assign entry.depth          = word[DEPTH-1:0];
  assign entry_beside.present = word_beside[BANK-1];
  assign entry_beside.depth   = word_beside[DEPTH-1:0];
  assign unused_bits          = ^{word[BANK-2:DEPTH], word_beside[BANK-2:DEPTH]};

  assign update           = hand && kind == KIND_UPDATE;
  assign modify_entry_o   = entry;
  assign modify_operand_o = payload[OPERAND_BITS-1:0];
  assign wrote_o          = update && modify_write_i;
  assign new_word         = {1'b1, (BANK - 1 - DEPTH)'(0), modify_depth_i};
  assign write            = wrote_o ? cache_pkg::BANKS'(1) << place : '0;

  // ---- Answers ----
  logic room0, room1, none0, none1, wants0, wants1, unused_kind;
  logic [1:0] first_kind;
  assign first_kind  = first_info[PLACE+PAYLOAD+:2];
  assign unused_kind = ^first_info[PLACE+PAYLOAD-1:0];
  assign wants0      = first_kind == KIND_READ0;
  assign wants1      = first_kind == KIND_READ1 || first_y;
  assign serve       = first && (room0 || !wants0) && (room1 || !wants1);
  cache_answers #(.WIDTH(ENTRY + TAG0_BITS)) u_answers0 (
    .clk_i, .rst_ni, .expect_i(serve && wants0), .room_o(room0), .valid_i(hand && kind == KIND_READ0),
    .data_i({entry, payload[TAG0_BITS-1:0]}), .valid_o(entry0_valid_o), .ready_i(entry0_ready_i),
    .data_o({entry0_o, entry0_tag_o}), .none_o(none0)
  );
  cache_answers #(.WIDTH(ENTRY + TAG1_BITS)) u_answers1 (
    .clk_i, .rst_ni, .expect_i(serve && wants1), .room_o(room1),
    .valid_i(hand && (kind == KIND_READ1 || hand_y)),
    .data_i(hand_y ? {entry_beside, tag_beside} : {entry, payload[TAG1_BITS-1:0]}), .valid_o(entry1_valid_o),
    .ready_i(entry1_ready_i), .data_o({entry1_o, entry1_tag_o}), .none_o(none1)
  );

  assign idle_o        = cache_idle && none0 && none1;
  assign clear_ready_o = cache_clear_ready && none0 && none1 && !update_valid_i && !read0_valid_i && !read1_valid_i;

endmodule
