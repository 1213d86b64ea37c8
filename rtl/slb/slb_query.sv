// SPDX-License-Identifier: Apache-2.0
// QUERY: reads the entry of a point, tests all its lines at once, answers in order, one point a cycle. What a point needs
// after its read travels with it as the tag, so that any number may be under way.
//
//   item ─► split ─► read port ─► terms of 2 K lines ─► their signs ─► groups, depths ─► answer

`include "assertions.svh"

module slb_query #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned PLANE_LOG2      = 8,
  parameter int unsigned QUERY_BITS      = 10,
  parameter int unsigned ROUNDING        = 0,
  // Derived; not to be overridden.
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS),
  parameter int unsigned TAG   = 2 * QUERY_BITS + 2 * DEPTH_BITS + 17
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // Items, with the bias of their command and their number in it.
  input  logic                    item_valid_i,
  output logic                    item_ready_o,
  input  logic [63:0]             item_i,
  input  logic [DEPTH_BITS-1:0]   bias_i,
  input  logic [15:0]             number_i,
  output logic                    idle_o,
  // Read port of the plane.
  output logic                    read_valid_o,
  input  logic                    read_ready_i,
  output logic [2*PLANE_LOG2-1:0] read_index_o,
  output logic [TAG-1:0]          read_tag_o,
  input  logic                    entry_valid_i,
  output logic                    entry_ready_o,
  input  logic [ENTRY-1:0]        entry_i,
  input  logic [TAG-1:0]          entry_tag_i,
  // SLB_ANSWER results.
  output logic                    result_valid_o,
  input  logic                    result_ready_i,
  output gnomon_pkg::slb_answer_t result_o
);

  localparam int unsigned P     = PLANE_LOG2;
  localparam int unsigned Q     = QUERY_BITS;
  localparam int unsigned D     = DEPTH_BITS;
  localparam int unsigned K     = FRAGS_PER_PIXEL;
  localparam int unsigned WIDTH = P + 2 + Q;  // of a coordinate
  localparam int unsigned L     = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS);
  localparam int unsigned CB    = slb_pkg::count_bits(K);
  localparam int unsigned TB    = slb_pkg::threshold_bits(K);
  localparam int unsigned OB    = slb_pkg::OBJECT_BITS;
  localparam int unsigned FB    = slb_pkg::fragment_bits(FRAC_BITS, SLOPE_BITS, K, D);
  localparam int unsigned POINT = Q + 1;
  localparam int unsigned TERM  = FRAC_BITS + SLOPE_BITS + POINT + 4;

  // ---- Split: a register between the item and the read port ----
  logic             valid0_q, free0, off_plane0_q;
  logic [P-1:0]     column0_q, row0_q;
  logic [Q-1:0]     x0_q, y0_q;
  logic [D-1:0]     depth0_q, bias0_q;
  logic [15:0]      number0_q;
  logic [WIDTH-1:0] x, y;
  assign {y, x}       = item_i[2*WIDTH-1:0];
  assign free0        = !valid0_q || read_ready_i;
  assign item_ready_o = free0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni)    valid0_q <= 1'b0;
    else if (free0) valid0_q <= item_valid_i;
  end
  always_ff @(posedge clk_i) begin
    if (free0 && item_valid_i) begin
      off_plane0_q <= x[WIDTH-1-:2] != '0 || y[WIDTH-1-:2] != '0;
      column0_q    <= x[Q+:P];
      row0_q       <= y[Q+:P];
      x0_q         <= x[Q-1:0];
      y0_q         <= y[Q-1:0];
      depth0_q     <= item_i[2*WIDTH+:D];
      bias0_q      <= bias_i;
      number0_q    <= number_i;
    end
  end
  assign read_valid_o = valid0_q;
  assign read_index_o = {row0_q, column0_q};  // of some entry, where the point is off the plane
  always_comb begin
    read_tag_o = 'x;
    if (valid0_q) read_tag_o = {off_plane0_q, number0_q, bias0_q, depth0_q, y0_q, x0_q};
  end

  // ---- The entry has come: stages 1 to 3 move together ----
  logic [2:0] valid_q;  // bit s - 1: stage s
  logic       en;
  assign en            = !valid_q[2] || result_ready_i;
  assign entry_ready_o = en;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else if (en) valid_q <= {valid_q[1:0], entry_valid_i};
  end

  // ---- Stage 1: terms of all lines, read at + 1/2 ulp; stage 2: the sign of their difference ----
  localparam int unsigned BESIDE = 1 + 16 + 2 * D;    // of the tag, without the position
  localparam int unsigned FIRST  = ENTRY - K * FB;    // lowest bit of the first fragment
  logic         take1, take2, take3;
  logic [2*K-1:0] contains2_q;
  assign take1 = en && entry_valid_i;
  assign take2 = en && valid_q[0];
  assign take3 = en && valid_q[1];
  for (genvar i = 0; i < 2 * K; i++) begin : gen_lines
    logic signed [TERM-1:0] offset, rise, offset1_q, rise1_q;
    logic                   inner, inner1_q;
    slb_line_terms #(
      .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .POINT_BITS(POINT), .ROUNDING(ROUNDING)
    ) u_terms (
      .valid_i(take1), .line_i(entry_i[FIRST+(i/2)*FB+D+OB+2+(i%2)*L+:L]), .x_i({entry_tag_i[0+:Q], 1'b1}),
      .y_i({entry_tag_i[Q+:Q], 1'b1}), .offset_o(offset), .rise_o(rise), .inner_o(inner)
    );
    always_ff @(posedge clk_i) begin
      if (take1) begin
        offset1_q <= offset;
        rise1_q   <= rise;
        inner1_q  <= inner;
      end
      // A border belongs to both sides.
      if (take2) begin
        if (inner1_q) contains2_q[i] <= mutations_pkg::SLB_OPEN_HALF_PLANE ? offset1_q > rise1_q : offset1_q >= rise1_q;
        else          contains2_q[i] <= offset1_q <= rise1_q;
      end
    end
  end
  // What else stages 1 and 2 carry: everything of the fragments but their lines.
  logic [K*D-1:0]    depths1_q, depths2_q;
  logic [K*OB-1:0]   objects1_q, objects2_q;
  logic [K*2-1:0]    ops1_q, ops2_q;
  logic [K*TB-1:0]   thresholds1_q, thresholds2_q;
  logic [K-1:0]      conts1_q, conts2_q;
  logic [D-1:0]      full1_q, full2_q;
  logic              overflow1_q, overflow2_q;
  logic [CB-1:0]     count1_q, count2_q;
  logic [BESIDE-1:0] beside1_q, beside2_q;
  always_ff @(posedge clk_i) begin
    if (take1) begin
      for (int i = 0; i < K; i++) begin
        depths1_q[i*D+:D]       <= entry_i[FIRST+i*FB+:D];
        objects1_q[i*OB+:OB]    <= entry_i[FIRST+i*FB+D+:OB];
        ops1_q[i*2+:2]          <= entry_i[FIRST+i*FB+D+OB+:2];
        thresholds1_q[i*TB+:TB] <= entry_i[FIRST+i*FB+FB-2-:TB];
        conts1_q[i]             <= entry_i[FIRST+i*FB+FB-1];
      end
      full1_q     <= entry_i[FIRST-1-:D];
      overflow1_q <= entry_i[CB];
      count1_q    <= entry_i[CB-1:0];
      beside1_q   <= entry_tag_i[TAG-1-:BESIDE];
    end
    if (take2) begin
      depths2_q     <= depths1_q;
      objects2_q    <= objects1_q;
      ops2_q        <= ops1_q;
      thresholds2_q <= thresholds1_q;
      conts2_q      <= conts1_q;
      full2_q       <= full1_q;
      overflow2_q   <= overflow1_q;
      count2_q      <= count1_q;
      beside2_q     <= beside1_q;
    end
  end
  logic unused_state;  // corner, open: 0 outside of objects
  assign unused_state = ^entry_i[FIRST-D-1:CB+1];

  // ---- Stage 3: the answer ----
  logic          off_plane, by_full, by_lines;
  logic [15:0]   number;
  logic [D-1:0]  bias, depth;
  logic [OB-1:0] object;
  logic [K-1:0]  in_a, in_b;
  assign {off_plane, number, bias, depth} = beside2_q;
  for (genvar i = 0; i < K; i++) begin : gen_contains
    assign in_a[i] = contains2_q[2*i];
    assign in_b[i] = contains2_q[2*i+1];
  end
  slb_answer #(.FRAGS_PER_PIXEL(K), .DEPTH_BITS(D)) u_answer (
    .valid_i(take3), .count_i(count2_q), .full_depth_i(full2_q), .depth_i(depths2_q), .object_i(objects2_q), .op_i(ops2_q),
    .threshold_i(thresholds2_q), .cont_i(conts2_q), .in_a_i(in_a), .in_b_i(in_b), .point_depth_i(depth),
    .bias_i(bias), .by_full_o(by_full), .by_lines_o(by_lines), .object_o(object)
  );
  gnomon_pkg::slb_answer_t answer, answer3_q;
  always_comb begin
    answer              = '0;
    answer.code         = gnomon_pkg::RESULT_SLB_ANSWER;
    answer.off_plane    = off_plane;
    answer.number       = number;
    if (take3 && !off_plane) begin
      answer.shadow       = by_full || by_lines;
      answer.by_full      = by_full;
      answer.by_lines     = by_lines;
      answer.has_fragment = count2_q != '0;
      answer.overflow     = overflow2_q;
      answer.object_id    = object;
    end
  end
  always_ff @(posedge clk_i) begin
    if (take3) answer3_q <= answer;
  end
  assign result_valid_o = valid_q[2];
  assign result_o       = answer3_q;

  assign idle_o = !valid0_q && valid_q == '0;  // and the read port is

  if (2 * WIDTH + D < 64) begin : gen_unused_item
    logic unused_item;
    assign unused_item = ^item_i[63:2*WIDTH+D];
  end

  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, {read_index_o, read_tag_o})
  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
