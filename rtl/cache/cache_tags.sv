// SPDX-License-Identifier: Apache-2.0
// Which line will be in which slot when the requests that are looked up now are served: two ways, the less recently used
// one is replaced. Look-up is combinational; a second request (y) only hits.

module cache_tags #(
  parameter int unsigned LINE_BITS = 14,
  parameter int unsigned SETS_LOG2 = 8
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 clear_i,        // forget all lines
  input  logic [LINE_BITS-1:0] x_line_i,
  output logic                 x_hit_o,
  output logic [SETS_LOG2:0]   x_slot_o,       // where it is, or will be: {set, way}
  output logic                 victim_o,       // without a hit: the slot holds a line ...
  output logic [LINE_BITS-1:0] victim_line_o,  // ... namely this one
  input  logic                 x_take_i,       // x is taken; after a miss its line has the slot
  input  logic [LINE_BITS-1:0] y_line_i,
  output logic                 y_hit_o,
  output logic [SETS_LOG2:0]   y_slot_o,
  input  logic                 y_take_i        // with a hit
);

  localparam int unsigned SETS = 1 << SETS_LOG2;
  localparam int unsigned TAG  = LINE_BITS - SETS_LOG2;

  logic [TAG-1:0]  tag0_q [SETS];
  logic [TAG-1:0]  tag1_q [SETS];
  logic [SETS-1:0] valid0_q, valid1_q;
  logic [SETS-1:0] next_q;  // the way to be replaced next

  logic [SETS_LOG2-1:0] x_set, y_set;
  logic [TAG-1:0]       x_tag, y_tag, x_tag0, x_tag1;
  assign {x_tag, x_set} = x_line_i;
  assign {y_tag, y_set} = y_line_i;
  assign x_tag0         = tag0_q[x_set];
  assign x_tag1         = tag1_q[x_set];

  logic x_hit0, x_hit1, y_hit0, y_hit1, x_way, fill_way;
  assign x_hit0   = valid0_q[x_set] && x_tag0 == x_tag;
  assign x_hit1   = valid1_q[x_set] && x_tag1 == x_tag;
  assign y_hit0   = valid0_q[y_set] && tag0_q[y_set] == y_tag;
  assign y_hit1   = valid1_q[y_set] && tag1_q[y_set] == y_tag;
  assign fill_way = valid0_q[x_set] && (!valid1_q[x_set] || next_q[x_set]);
  assign x_hit_o  = x_hit0 || x_hit1;
  assign y_hit_o  = y_hit0 || y_hit1;
  assign x_way    = x_hit_o ? x_hit1 : fill_way;
  assign x_slot_o = {x_set, x_way};
  assign y_slot_o = {y_set, y_hit1};

  assign victim_o      = fill_way ? valid1_q[x_set] : valid0_q[x_set];
  assign victim_line_o = {fill_way ? x_tag1 : x_tag0, x_set};

  always_ff @(posedge clk_i) begin
    if (!rst_ni || clear_i) begin
      valid0_q <= '0;
      valid1_q <= '0;
      next_q   <= '0;
    end else begin
      if (x_take_i) begin
        if (x_way) valid1_q[x_set] <= 1'b1;
        else       valid0_q[x_set] <= 1'b1;
        next_q[x_set] <= !x_way;
      end
      if (y_take_i) next_q[y_set] <= !y_hit1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (x_take_i && !x_way) tag0_q[x_set] <= x_tag;
  end
  always_ff @(posedge clk_i) begin
    if (x_take_i && x_way) tag1_q[x_set] <= x_tag;
  end

endmodule
