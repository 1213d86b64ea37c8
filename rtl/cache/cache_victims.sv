// SPDX-License-Identifier: Apache-2.0
// Lines on their way out, remembered from the miss that takes over their slot until they prove clean or their write is
// answered, so that none is asked for before it has arrived.

`include "assertions.svh"

module cache_victims #(
  parameter int unsigned LINE_BITS = 14,
  parameter int unsigned ID_BITS   = 5   // 2^ID_BITS are remembered
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  // A miss takes over a slot.
  input  logic                 add_i,         // only with room
  input  logic                 add_victim_i,  // the slot holds a line
  input  logic [LINE_BITS-1:0] add_line_i,
  output logic                 room_o,
  // Is this line on its way out? Combinational.
  input  logic [LINE_BITS-1:0] line_i,
  output logic                 leaving_o,
  // The oldest miss not yet served: its victim, if it has one.
  output logic                 victim_o,
  output logic [LINE_BITS-1:0] victim_line_o,
  output logic [ID_BITS-1:0]   victim_id_o,
  input  logic                 serve_i,       // it is served now
  input  logic                 write_i,       // ... and its victim has to be written
  // Written.
  input  logic                 written_valid_i,
  input  logic [ID_BITS-1:0]   written_id_i,
  output logic                 none_o
);

  localparam int unsigned COUNT = 1 << ID_BITS;

  logic [COUNT-1:0]           leaving_q;
  logic [COUNT*LINE_BITS-1:0] lines_q;
  logic [ID_BITS-1:0]         new_q, serve_q;
  logic                       written_valid_q;  // a cycle later, so that the line's bit is sure to say that it was touched
  logic [ID_BITS-1:0]         written_id_q;

  // Fewer misses than there are places are not yet served, so that a place is used again only when it is known what became
  // of its victim.
  assign room_o        = !leaving_q[new_q];
  assign victim_o      = leaving_q[serve_q];
  assign victim_line_o = lines_q[serve_q*LINE_BITS+:LINE_BITS];
  assign victim_id_o   = serve_q;
  assign none_o        = leaving_q == '0;

  logic [COUNT-1:0] same;
  for (genvar i = 0; i < COUNT; i++) begin : gen_lines
    assign same[i] = leaving_q[i] && lines_q[i*LINE_BITS+:LINE_BITS] == line_i;
    always_ff @(posedge clk_i) begin
      if (add_i && new_q == ID_BITS'(i)) lines_q[i*LINE_BITS+:LINE_BITS] <= add_line_i;
    end
  end
  assign leaving_o = same != '0 && !mutations_pkg::CACHE_FETCH_EARLY;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      leaving_q       <= '0;
      new_q           <= '0;
      serve_q         <= '0;
      written_valid_q <= 1'b0;
    end else begin
      written_valid_q <= written_valid_i;
      if (add_i) begin
        leaving_q[new_q] <= add_victim_i;
        new_q            <= new_q + 1'b1;
      end
      if (serve_i) begin
        if (!write_i) leaving_q[serve_q] <= 1'b0;
        serve_q <= serve_q + 1'b1;
      end
      if (written_valid_q) leaving_q[written_id_q] <= 1'b0;
    end
  end
  always_ff @(posedge clk_i) written_id_q <= written_id_i;

  `GNOMON_ASSERT(a_add_has_room, !add_i || room_o)
  `GNOMON_ASSERT(a_written_was_leaving, !written_valid_q || leaving_q[written_id_q])
  `GNOMON_ASSERT(a_write_a_victim, !write_i || (serve_i && victim_o))

endmodule
