// SPDX-License-Identifier: Apache-2.0
// Quotients of edge set-up (docs/slb.md, "Set-up: two quotients", "Depth along an edge"). Edges leave in order, with
// their quotients:
//
//   edge ─► differences ─► |dm|·distance ─► issue ─► pipelined dividers ─┐
//     └───────► slots, a ring that holds an edge until its quotients are there ─► out
//
// An edge inside one pixel passes without a quotient. All dividers have the same latency, so edges are complete in order.

`include "assertions.svh"

module slb_edge_divide #(
  parameter int unsigned FRAC_BITS     = 7,
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  parameter int unsigned DIVIDERS      = 2,
  parameter int unsigned BESIDE        = 1,
  // Derived; not to be overridden.
  parameter int unsigned W = PLANE_LOG2 + 2 + SUBPIXEL_BITS,
  parameter int unsigned K = FRAC_BITS + SUBPIXEL_BITS
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  valid_i,
  output logic                  ready_o,
  input  logic [W-1:0]          x0_i, y0_i, x1_i, y1_i,
  input  logic [DEPTH_BITS-1:0] depth0_i, depth1_i,
  input  logic                  first_i, last_i,
  input  logic [BESIDE-1:0]     beside_i,  // passes through
  output logic                  valid_o,
  input  logic                  ready_i,
  output logic [W-1:0]          x0_o, y0_o, x1_o, y1_o,
  output logic [DEPTH_BITS-1:0] depth0_o, depth1_o,
  output logic                  first_o, last_o,
  output logic [BESIDE-1:0]     beside_o,
  // Quotients and remainders; meaningless where the page asks for none.
  output logic [K-1:0]          ahead_q_o, step_q_o,
  output logic [W-1:0]          ahead_r_o, step_r_o,
  output logic [DEPTH_BITS-1:0] depth_q_o,
  output logic [W-1:0]          depth_r_o,
  output logic                  idle_o
);

  localparam int unsigned S         = SUBPIXEL_BITS;
  localparam int unsigned D         = DEPTH_BITS;
  localparam int unsigned STAGES    = (K > D) ? K : D;  // a shorter quotient gets zeros in front
  localparam int unsigned SLOT_LOG2 = 5;                // above STAGES + 3, so that the ring never holds an edge back
  localparam int unsigned SLOTS     = 1 << SLOT_LOG2;
  localparam int unsigned DIVIDEND  = W + STAGES;
  // Quotients by number: where the edge meets its first border, from border to border, depth from border to border.
  localparam logic [1:0] AHEAD = 2'd0, STEP = 2'd1, DEPTH = 2'd2;

  // Slots in a ring: [read, done) are complete, [done, write) under way.
  logic [SLOT_LOG2:0] write_q, done_q, read_q;
  logic               full;
  assign full = (write_q ^ read_q) == (SLOT_LOG2 + 1)'(SLOTS);

  logic                 y_major, forward, falling, level;
  logic signed [W:0]    dx, dy;
  logic [W-1:0]         den, minor_abs;
  logic [S:0]           distance;
  slb_edge_delta #(.W(W), .SUBPIXEL_BITS(S)) u_delta (
    .valid_i, .x0_i, .y0_i, .x1_i, .y1_i, .dx_o(dx), .dy_o(dy), .y_major_o(y_major), .forward_o(forward), .falling_o(falling),
    .level_o(level), .den_o(den), .minor_abs_o(minor_abs), .distance_o(distance)
  );
  logic unused_delta;
  assign unused_delta = ^{y_major, forward, falling, level, dx, dy};

  logic         one_pixel, deep;  // one pixel has it all; longer than a pixel with a sloping depth
  logic [D-1:0] depth_abs;
  assign one_pixel = x0_i[W-1:S] == x1_i[W-1:S] && y0_i[W-1:S] == y1_i[W-1:S];
  assign deep      = den > W'(1 << S) && depth0_i != depth1_i;
  assign depth_abs = (depth1_i > depth0_i) ? depth1_i - depth0_i : depth0_i - depth1_i;

  // Differences, then the product, then issue. `want` has a bit for each quotient not asked for yet.
  logic                 delta_valid_q, product_valid_q, issue_valid_q;
  logic [2:0]           delta_want_q, product_want_q, issue_want_q;
  logic [SLOT_LOG2-1:0] delta_slot_q, product_slot_q, issue_slot_q;
  logic [W-1:0]         delta_den_q, product_den_q, issue_den_q;
  logic [W-1:0]         delta_minor_q, product_minor_q, issue_minor_q;
  logic [D-1:0]         delta_depth_q, product_depth_q, issue_depth_q;
  logic [S:0]           delta_distance_q;
  logic [W+S:0]         product_q, issue_product_q;

  logic issue_ends, steal;  // the edge at issue asks for its last quotient; the one behind it joins with its first
  logic issue_advance, product_advance, delta_advance;
  assign issue_advance   = !issue_valid_q || issue_ends;
  assign product_advance = !product_valid_q || issue_advance;
  assign delta_advance   = !delta_valid_q || product_advance;
  assign ready_o         = delta_advance && !full;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {delta_valid_q, product_valid_q, issue_valid_q} <= '0;
      write_q                                         <= '0;
    end else begin
      if (delta_advance)   delta_valid_q   <= valid_i && !full;
      if (product_advance) product_valid_q <= delta_valid_q;
      if (issue_advance)   issue_valid_q   <= product_valid_q;
      if (valid_i && ready_o) write_q <= write_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (delta_advance && valid_i) begin
      delta_want_q     <= one_pixel ? 3'b000 : {deep, 2'b11};
      delta_slot_q     <= write_q[SLOT_LOG2-1:0];
      delta_den_q      <= den;
      delta_minor_q    <= minor_abs;
      delta_depth_q    <= depth_abs;
      delta_distance_q <= distance;
    end
    if (product_advance && delta_valid_q) begin
      product_want_q  <= delta_want_q;
      product_slot_q  <= delta_slot_q;
      product_den_q   <= delta_den_q;
      product_minor_q <= delta_minor_q;
      product_depth_q <= delta_depth_q;
      product_q       <= (W+S+1)'(delta_minor_q) * (W+S+1)'(delta_distance_q);
    end
    if (issue_advance) begin
      issue_want_q    <= product_want_q & {2'b11, !steal};
      issue_slot_q    <= product_slot_q;
      issue_den_q     <= product_den_q;
      issue_minor_q   <= product_minor_q;
      issue_depth_q   <= product_depth_q;
      issue_product_q <= product_q;
    end else begin
      // Only where there are more quotients wanted than dividers: those asked for leave the mask, lowest first.
      issue_want_q <= (DIVIDERS == 1) ? issue_want_q & (issue_want_q - 3'd1) : issue_want_q & 3'b100;
    end
  end

  // Times D0 = 2^F - 1.
  localparam int unsigned F = FRAC_BITS;
  function automatic logic [DIVIDEND-1:0] times_d0(logic [W+S:0] value);
    times_d0 = (DIVIDEND'(value) << F) - DIVIDEND'(value);
  endfunction

  // What divider `lane` is asked for. Wanted are the last n of the three, or the first two, or the second alone.
  logic [2:0] wanted;
  logic [2:0] lane_valid;
  logic [5:0] lane_kind;
  assign wanted         = 3'(issue_want_q[0]) + 3'(issue_want_q[1]) + 3'(issue_want_q[2]);
  assign issue_ends     = wanted <= 3'(DIVIDERS);
  assign steal          = DIVIDERS == 2 && issue_valid_q && wanted <= 3'd1 && product_valid_q && product_want_q[0];
  assign lane_valid[0]  = issue_valid_q && wanted != 3'd0;
  assign lane_valid[1]  = (issue_valid_q && wanted >= 3'd2) || steal;
  assign lane_valid[2]  = issue_valid_q && wanted == 3'd3;
  assign lane_kind[1:0] = issue_want_q[0] ? AHEAD : issue_want_q[1] ? STEP : DEPTH;
  assign lane_kind[3:2] = steal ? AHEAD : issue_want_q[0] ? STEP : DEPTH;
  assign lane_kind[5:4] = DEPTH;

  // Quotients come back with their number and slot; never two of one number in a cycle, as a stolen lane asks for
  // AHEAD beside STEP or DEPTH.
  logic [2:0]             back_valid;
  logic [5:0]             back_kind;
  logic [3*SLOT_LOG2-1:0] back_slot;
  logic [3*(STAGES+W)-1:0] back;

  for (genvar lane = 0; lane < 3; lane++) begin : gen_lanes
    if (lane < DIVIDERS) begin : gen_divider
      logic                stolen;
      logic [DIVIDEND-1:0] dividend;
      assign stolen = lane == 1 && steal;
      always_comb begin
        case (lane_kind[2*lane+:2])
          AHEAD:   dividend = times_d0(stolen ? product_q : issue_product_q);
          STEP:    dividend = times_d0({1'b0, issue_minor_q, {S{1'b0}}});
          default: dividend = DIVIDEND'({issue_depth_q, {S{1'b0}}});
        endcase
      end
      slb_divider #(.DEN_BITS(W), .QUOTIENT_BITS(STAGES), .TAG_BITS(SLOT_LOG2 + 2)) u_divider (
        .clk_i, .rst_ni,
        .valid_i    (lane_valid[lane]),
        .dividend_i (dividend),
        .den_i      (stolen ? product_den_q : issue_den_q),
        .tag_i      ({lane_kind[2*lane+:2], stolen ? product_slot_q : issue_slot_q}),
        .valid_o    (back_valid[lane]),
        .quotient_o (back[lane*(STAGES+W)+W+:STAGES]),
        .remainder_o(back[lane*(STAGES+W)+:W]),
        .tag_o      ({back_kind[2*lane+:2], back_slot[lane*SLOT_LOG2+:SLOT_LOG2]})
      );
    end else begin : gen_none
      logic unused_lane;
      assign unused_lane                            = ^{lane_valid[lane], lane_kind[2*lane+:2]};
      assign back_valid[lane]                       = 1'b0;
      assign back_kind[2*lane+:2]                   = DEPTH;
      assign back_slot[lane*SLOT_LOG2+:SLOT_LOG2]   = '0;
      assign back[lane*(STAGES+W)+:STAGES+W]        = '0;
    end
  end

  // An edge is complete when the quotient that it asked for last is.
  logic [STAGES-1:0] ends_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ends_q <= '0;
      done_q <= '0;
    end else begin
      ends_q <= {ends_q[STAGES-2:0], issue_valid_q && issue_ends};
      if (ends_q[STAGES-1]) done_q <= done_q + 1'b1;
    end
  end

  logic [2*W-1:0]    start_q  [SLOTS];
  logic [2*W-1:0]    end_q    [SLOTS];
  logic [2*D+1:0]    depth_q  [SLOTS];
  logic [BESIDE-1:0] beside_q [SLOTS];
  always_ff @(posedge clk_i) begin
    if (valid_i && ready_o) begin
      start_q[write_q[SLOT_LOG2-1:0]]  <= {x0_i, y0_i};
      end_q[write_q[SLOT_LOG2-1:0]]    <= {x1_i, y1_i};
      depth_q[write_q[SLOT_LOG2-1:0]]  <= {depth0_i, depth1_i, first_i, last_i};
      beside_q[write_q[SLOT_LOG2-1:0]] <= beside_i;
    end
  end

  logic                load;
  logic                out_valid_q;
  logic [3*(STAGES+W)-1:0] quotients;  // by number
  assign load = read_q != done_q && (!out_valid_q || ready_i);
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      read_q      <= '0;
      out_valid_q <= 1'b0;
    end else begin
      if (load)                         read_q <= read_q + 1'b1;
      if (!out_valid_q || ready_i) out_valid_q <= load;
    end
  end
  for (genvar kind = 0; kind < 3; kind++) begin : gen_quotients
    logic [2:0]           hit;
    logic [SLOT_LOG2-1:0] slot;
    logic [STAGES+W-1:0]  value, value_q;
    logic [STAGES+W-1:0]  values_q [SLOTS];
    always_comb begin
      slot  = back_slot[0+:SLOT_LOG2];
      value = back[0+:STAGES+W];
      for (int unsigned lane = 0; lane < 3; lane++) begin
        hit[lane] = back_valid[lane] && back_kind[2*lane+:2] == 2'(kind);
        if (hit[lane]) begin
          slot  = back_slot[lane*SLOT_LOG2+:SLOT_LOG2];
          value = back[lane*(STAGES+W)+:STAGES+W];
        end
      end
    end
    always_ff @(posedge clk_i) begin
      if (hit != '0) values_q[slot] <= value;
      if (load)      value_q        <= values_q[read_q[SLOT_LOG2-1:0]];
    end
    assign quotients[kind*(STAGES+W)+:STAGES+W] = value_q;

    `GNOMON_ASSERT(a_one_of_a_number, (hit & (hit - 3'd1)) == '0)
  end
  always_ff @(posedge clk_i) begin
    if (load) begin
      {x0_o, y0_o}                          <= start_q[read_q[SLOT_LOG2-1:0]];
      {x1_o, y1_o}                          <= end_q[read_q[SLOT_LOG2-1:0]];
      {depth0_o, depth1_o, first_o, last_o} <= depth_q[read_q[SLOT_LOG2-1:0]];
      beside_o                              <= beside_q[read_q[SLOT_LOG2-1:0]];
    end
  end
  assign valid_o = out_valid_q;

  // Narrowings: the zeros in front of a quotient shorter than the divider.
  assign ahead_r_o = quotients[0+:W];
  assign ahead_q_o = quotients[W+:K];
  assign step_r_o  = quotients[STAGES+W+:W];
  assign step_q_o  = quotients[STAGES+2*W+:K];
  assign depth_r_o = quotients[2*(STAGES+W)+:W];
  assign depth_q_o = quotients[2*(STAGES+W)+W+:D];
  logic unused_zeros;
  assign unused_zeros = ^quotients;

  assign idle_o = write_q == read_q && !out_valid_q;

  `GNOMON_ASSERT(a_ring_in_order, (SLOT_LOG2 + 1)'(done_q - read_q) <= (SLOT_LOG2 + 1)'(write_q - read_q))

endmodule
