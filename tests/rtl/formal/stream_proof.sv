// SPDX-License-Identifier: Apache-2.0
// Proof harness of the stream cells: for any environment that obeys the stream rules, the cell obeys them, and the word
// that leaves as number k is the word that entered as number k, whatever k. CELL is the module under proof,
// CELL_PARAMETERS what it is built with besides its width.

module stream_proof (
  input logic       clk_i,
  input logic       valid_i,
  input logic [1:0] data_i,
  input logic       ready_i
);

  // Reset in the first cycle, none after.
  logic running_q = 1'b0;
  always_ff @(posedge clk_i) running_q <= 1'b1;

  logic       ready, valid;
  logic [1:0] data;
  `CELL #(.WIDTH(2) `CELL_PARAMETERS) u_cell (
    .clk_i, .rst_ni(running_q), .valid_i, .ready_o(ready), .data_i, .valid_o(valid), .ready_i, .data_o(data)
  );

  // The environment keeps an offered word.
  always_ff @(posedge clk_i) begin
    if (running_q && $past(running_q) && $past(valid_i && !ready)) begin
      assume (valid_i);
      assume (data_i == $past(data_i));
    end
  end

  (* anyconst *) logic [2:0] number;
  logic [2:0] taken_q, given_q;  // words so far, modulo 8: more than the cell holds
  logic       seen_q;            // word `number` has entered and not yet left
  logic [1:0] word_q;
  always_ff @(posedge clk_i) begin
    if (!running_q) begin
      taken_q <= '0;
      given_q <= '0;
      seen_q  <= 1'b0;
    end else begin
      if (valid_i && ready) begin
        taken_q <= taken_q + 3'd1;
        if (taken_q == number) begin
          seen_q <= 1'b1;
          word_q <= data_i;
        end
      end
      if (valid && ready_i) begin
        given_q <= given_q + 3'd1;
        if (given_q == number) begin
          seen_q <= 1'b0;
          a_same_word: assert (seen_q && data == word_q);
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (running_q) begin
      a_nothing_from_nothing: assert (!valid || taken_q != given_q);
      c_three_in_a_row: cover (taken_q == 3'd4 && given_q == 3'd3);
    end
  end

endmodule
