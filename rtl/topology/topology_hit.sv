// SPDX-License-Identifier: Apache-2.0
// Does a beam hit one of a quad's triangles c0 c1 c2 and c0 c2 c3? Exact, in four stages without a stall: corners seen
// from the beam, products, edge functions, decision. A tag goes along.

module topology_hit #(
  parameter int unsigned PLANE_LOG2 = 9,
  parameter int unsigned SUB_BITS   = 4,
  parameter int unsigned SPAN_LOG2  = 4,
  parameter int unsigned TAG_BITS   = 8,
  // Derived; not to be overridden.
  parameter int unsigned PLACE  = PLANE_LOG2 + SUB_BITS,
  parameter int unsigned RECORD = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2)
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                valid_i,
  input  logic [RECORD-1:0]   record_i,
  input  logic [PLACE-1:0]    u_i, v_i,   // the beam; it lies in the quad's box
  input  logic [TAG_BITS-1:0] tag_i,
  output logic                valid_o,
  output logic                hit_o,
  output logic [TAG_BITS-1:0] tag_o
);

  localparam int unsigned DELTA   = SPAN_LOG2 + SUB_BITS;
  localparam int unsigned SIDE    = DELTA + 1;     // signed difference of two deltas
  localparam int unsigned PRODUCT = 2 * SIDE - 1;  // |x| < 2^DELTA: below 2^(2 DELTA) in size, and a sign
  localparam int unsigned EDGE    = PRODUCT + 1;

  // ---- The beam from the quad's base: it lies in the box, so that SPAN_LOG2 bits of the entries say it all ----
  localparam int unsigned ENTRY = PLANE_LOG2 + SPAN_LOG2;  // wide enough for both
  logic [ENTRY-1:0]     u_entry, v_entry;
  logic [SPAN_LOG2-1:0] u_base, v_base;
  logic [DELTA-1:0]     u, v;
  logic                 unused_entry;
  assign u_entry          = ENTRY'(u_i[PLACE-1:SUB_BITS]);
  assign v_entry          = ENTRY'(v_i[PLACE-1:SUB_BITS]);
  assign {v_base, u_base} = record_i[8*DELTA+:2*SPAN_LOG2];
  assign u                = {u_entry[SPAN_LOG2-1:0] - u_base, u_i[SUB_BITS-1:0]};
  assign v                = {v_entry[SPAN_LOG2-1:0] - v_base, v_i[SUB_BITS-1:0]};
  assign unused_entry     = ^{u_entry[ENTRY-1:SPAN_LOG2], v_entry[ENTRY-1:SPAN_LOG2]};

  // ---- Stage 1: corners seen from the beam ----
  logic [4*SIDE-1:0] x_q, y_q;  // two's complement; corner 0 in the low bits
  for (genvar i = 0; i < 4; i++) begin : gen_corners
    always_ff @(posedge clk_i) begin
      x_q[i*SIDE+:SIDE] <= {1'b0, record_i[i*2*DELTA+:DELTA]} - {1'b0, u};
      y_q[i*SIDE+:SIDE] <= {1'b0, record_i[i*2*DELTA+DELTA+:DELTA]} - {1'b0, v};
    end
  end

  // ---- Stages 2 and 3: e(0,1), e(1,2), e(2,0), e(2,3), e(3,0) ----
  logic [4:0] negative, zero;
  for (genvar k = 0; k < 5; k++) begin : gen_edges
    localparam int unsigned FROM = (k < 3) ? k : k - 1;
    localparam int unsigned TO   = (k == 2 || k == 4) ? 0 : FROM + 1;
    logic signed [SIDE-1:0]    xi, yi, xj, yj;
    logic signed [PRODUCT-1:0] forward_q, backward_q;
    logic signed [EDGE-1:0]    edge_q;
    assign xi = x_q[FROM*SIDE+:SIDE];
    assign yi = y_q[FROM*SIDE+:SIDE];
    assign xj = x_q[TO*SIDE+:SIDE];
    assign yj = y_q[TO*SIDE+:SIDE];
    always_ff @(posedge clk_i) begin
      forward_q  <= PRODUCT'(xi) * PRODUCT'(yj);
      backward_q <= PRODUCT'(xj) * PRODUCT'(yi);
      edge_q     <= EDGE'(forward_q) - EDGE'(backward_q);
    end
    assign negative[k] = edge_q[EDGE-1];
    assign zero[k]     = edge_q == '0;
  end

  // ---- Stage 4: all >= 0 or all <= 0, and not all 0; e(0,2) = -e(2,0) ----
  logic [2:0] below0, level0, below1, level1;
  logic       hit0, hit1;
  assign below0 = negative[2:0];
  assign level0 = zero[2:0];
  assign below1 = {negative[4:3], !negative[2] && !zero[2]};
  assign level1 = {zero[4:3], zero[2]};
  assign hit0   = (below0 == '0 || (below0 | level0) == '1) && level0 != '1;
  assign hit1   = (below1 == '0 || (below1 | level1) == '1) && level1 != '1;
  logic open0, open1;
  assign open0  = mutations_pkg::TOPOLOGY_OPEN_SIDES && level0 != '0;
  assign open1  = mutations_pkg::TOPOLOGY_OPEN_SIDES && level1 != '0;
  always_ff @(posedge clk_i) hit_o <= (hit0 && !open0) || (hit1 && !open1);

  logic [3:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[2:0], valid_i};
  end
  delay_line #(.WIDTH(TAG_BITS), .CYCLES(4)) u_tag (.clk_i, .data_i(tag_i), .data_o(tag_o));
  assign valid_o = valid_q[3];

endmodule
