// SPDX-License-Identifier: Apache-2.0
// Answers of LOOKUP_FRAME: states in words of up to 24, or whole bricks in three words. The bricks come from the read port
// in order, with their tags.

`include "assertions.svh"

module frame_lookup (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  // A brick that was asked for.
  input  logic                             entry_valid_i,
  output logic                             entry_ready_o,
  input  logic                             present_i,     // else it is empty
  input  logic [frame_pkg::BRICK_BITS-1:0] brick_i,
  input  frame_pkg::tag_t                  tag_i,
  // FRAME_STATES words.
  output logic                             result_valid_o,
  input  logic                             result_ready_i,
  output frame_pkg::frame_states_t         result_o,
  // Events, one an item.
  output logic                             lookup_o,
  output logic                             lookup_empty_o,
  output logic                             brick_o
);

  localparam int unsigned STATES = frame_pkg::WORD_STATES * frame_pkg::STATE_BITS;  // bits of a word's states

  logic [frame_pkg::BRICK_BITS-1:0] brick;
  logic [1:0]                       state;
  logic                             take;
  assign brick = present_i ? brick_i : '0;
  assign state = brick[{tag_i.place, 1'b0}+:2];
  assign take  = entry_valid_i && entry_ready_o;

  // ---- States, collected until a word is full or its command ends ----
  logic [4:0]        count_q;   // states so far, 0..23
  logic [STATES-1:0] states_q;  // above them zero
  logic [STATES-1:0] states;
  logic              ends;
  assign states = states_q | (STATES'(state) << {count_q, 1'b0});
  assign ends   = count_q == 5'(frame_pkg::WORD_STATES - 1) || (tag_i.last && !mutations_pkg::FRAME_SHARE_WORDS);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q  <= '0;
      states_q <= '0;
    end else if (take && !tag_i.brick) begin
      count_q  <= ends ? '0 : count_q + 5'd1;
      states_q <= ends ? '0 : states;
    end
  end

  // ---- Bricks, a word after the other ----
  logic [1:0] word_q;  // 0, 1, 2
  logic       last_word, given;
  assign last_word = word_q == 2'd2;
  assign given     = result_valid_o && result_ready_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)                     word_q <= '0;
    else if (tag_i.brick && given)   word_q <= last_word ? '0 : word_q + 2'd1;
  end

  assign result_valid_o = entry_valid_i && (tag_i.brick || ends);
  assign entry_ready_o  = tag_i.brick ? (last_word && result_ready_i) : (!ends || result_ready_i);
  always_comb begin
    result_o.code = gnomon_pkg::RESULT_FRAME_STATES;
    if (tag_i.brick) begin
      result_o.count = last_word ? 8'(frame_pkg::LAST_STATES) : 8'(frame_pkg::WORD_STATES);
      case (word_q)
        2'd0:    result_o.states = brick[0+:STATES];
        2'd1:    result_o.states = brick[STATES+:STATES];
        default: result_o.states = STATES'(brick[2*STATES+:2*frame_pkg::LAST_STATES]);
      endcase
    end else begin
      result_o.count  = 8'(count_q) + 8'd1;
      result_o.states = states;
    end
  end

  assign lookup_o       = take && !tag_i.brick;
  assign lookup_empty_o = lookup_o && state == frame_pkg::STATE_EMPTY;
  assign brick_o        = take && tag_i.brick;

  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
