// SPDX-License-Identifier: Apache-2.0
// From vertices to edges (docs/slb.md, "Loops"): drops repeats, holds a loop back until it has three vertices, closes it,
// and finds loops that never leave their first pixel. The last edge of a loop always goes to its first vertex; it has no
// length if the vertex before is the same.

`include "assertions.svh"

module slb_edge_loop #(
  parameter int unsigned DEPTH_BITS    = 20,
  parameter int unsigned PLANE_LOG2    = 8,
  parameter int unsigned SUBPIXEL_BITS = 10,
  // Derived; not to be overridden.
  parameter int unsigned W = PLANE_LOG2 + 2 + SUBPIXEL_BITS
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  in_valid_i,
  output logic                  in_ready_o,
  input  logic                  in_close_i,
  input  logic [W-1:0]          in_x_i, in_y_i,
  input  logic [DEPTH_BITS-1:0] in_depth_i,
  // Edges.
  output logic                  edge_valid_o,
  input  logic                  edge_ready_i,
  output logic [W-1:0]          edge_x0_o, edge_y0_o, edge_x1_o, edge_y1_o,
  output logic [DEPTH_BITS-1:0] edge_depth0_o, edge_depth1_o,
  output logic                  edge_first_o, edge_last_o,  // of its loop
  // Pulses for the counters.
  output logic                  event_vertex_o, event_repeated_o, event_loop_o, event_short_o,
  output logic                  event_tiny_o,
  output logic [63:0]           event_tiny_area2_o,
  output logic                  idle_o
);

  localparam int unsigned V = 2 * W + DEPTH_BITS;  // a vertex: depth, y, x from bit 0 up

  logic [V-1:0] vertex, origin_q, before_q, last_q;  // the loop's first vertex, and its last two
  logic [1:0]   count_q;                             // of vertices: 0, 1, 2, or 3 and more
  logic         again_q;                             // the third vertex brings two edges; the second is still to come
  assign vertex = {in_x_i, in_y_i, in_depth_i};

  logic         edge_valid_q, edge_first_q, edge_last_q;
  logic [V-1:0] edge_from_q, edge_to_q;

  logic advance, take, repeated, add, emit;
  assign advance    = !edge_valid_q || edge_ready_i;
  assign in_ready_o = advance && !again_q;
  assign take       = in_valid_i && in_ready_o;
  // Of a vertex with its predecessor; at the close, of the first with the last.
  assign repeated   = count_q != 2'd0 &&
                      (in_close_i ? origin_q[V-1:DEPTH_BITS] : vertex[V-1:DEPTH_BITS]) == last_q[V-1:DEPTH_BITS];
  assign add        = take && !in_close_i && !repeated;
  assign emit       = in_close_i ? (take && count_q == 2'd3) : (add && count_q[1]);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q      <= 2'd0;
      again_q      <= 1'b0;
      edge_valid_q <= 1'b0;
    end else begin
      if (take && in_close_i)          count_q <= 2'd0;
      else if (add && count_q != 2'd3) count_q <= count_q + 2'd1;
      if (advance) begin
        again_q      <= emit && count_q == 2'd2;
        edge_valid_q <= emit || again_q;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (add) begin
      before_q <= last_q;
      last_q   <= vertex;
      if (count_q == 2'd0) origin_q <= vertex;
    end
    if (advance) begin
      edge_from_q  <= again_q ? before_q : (count_q == 2'd2) ? origin_q : last_q;
      edge_to_q    <= (again_q || count_q == 2'd2) ? last_q : in_close_i ? origin_q : vertex;
      edge_first_q <= count_q == 2'd2;
      edge_last_q  <= !again_q && in_close_i;
    end
  end

  assign edge_valid_o  = edge_valid_q;
  assign edge_first_o  = edge_first_q;
  assign edge_last_o   = edge_last_q;
  assign {edge_x0_o, edge_y0_o, edge_depth0_o} = edge_from_q;
  assign {edge_x1_o, edge_y1_o, edge_depth1_o} = edge_to_q;

  assign event_vertex_o   = take && !in_close_i;
  assign event_repeated_o = take && repeated && (!in_close_i || (count_q == 2'd3 && !mutations_pkg::SLB_COUNT_CLOSE));
  assign event_loop_o     = take && in_close_i;
  assign event_short_o    = event_loop_o && count_q != 2'd3;

  // Twice the area while the loop is in its first pixel: differences, products, sum.
  localparam int unsigned S  = SUBPIXEL_BITS;
  localparam int unsigned XL = W + DEPTH_BITS;  // lowest bits of x and y in a vertex
  localparam int unsigned YL = DEPTH_BITS;

  logic inside_q, same_pixel;  // every vertex so far is in the first one's pixel
  assign same_pixel = vertex[V-1:XL+S] == origin_q[V-1:XL+S] && vertex[XL-1:YL+S] == origin_q[XL-1:YL+S];
  always_ff @(posedge clk_i) begin
    if (add) inside_q <= count_q == 2'd0 || (inside_q && same_pixel);
  end

  logic                  add_1_q, add_2_q, end_1_q, end_2_q, tiny_1_q, tiny_2_q;
  logic signed [S:0]     ax_q, ay_q, bx_q, by_q;  // within a pixel: |difference| < 2^s
  logic signed [2*S+2:0] cross_q;                 // two products of 2s + 2 bits
  logic signed [63:0]    sum_q;                   // grows with the loop; 2^30 edges as long as a pixel fit
  logic                  tiny_q;
  logic [63:0]           area2_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {add_1_q, add_2_q, end_1_q, end_2_q, tiny_q} <= '0;
      sum_q                                       <= '0;
    end else begin
      add_1_q <= add && count_q != 2'd0 && inside_q && same_pixel;
      end_1_q <= event_loop_o;
      add_2_q <= add_1_q;
      end_2_q <= end_1_q;
      tiny_q  <= end_2_q && tiny_2_q;
      if (end_2_q)      sum_q <= '0;
      else if (add_2_q) sum_q <= sum_q + 64'(cross_q);
    end
  end
  always_ff @(posedge clk_i) begin
    if (add) begin
      ax_q <= signed'({1'b0, last_q[XL+:S]}) - signed'({1'b0, origin_q[XL+:S]});
      ay_q <= signed'({1'b0, last_q[YL+:S]}) - signed'({1'b0, origin_q[YL+:S]});
      bx_q <= signed'({1'b0, vertex[XL+:S]}) - signed'({1'b0, origin_q[XL+:S]});
      by_q <= signed'({1'b0, vertex[YL+:S]}) - signed'({1'b0, origin_q[YL+:S]});
    end
    tiny_1_q <= count_q == 2'd3 && inside_q;
    cross_q  <= (2*S+3)'(ax_q) * (2*S+3)'(by_q) - (2*S+3)'(ay_q) * (2*S+3)'(bx_q);
    tiny_2_q <= tiny_1_q;
    area2_q  <= sum_q[63] ? 64'(-sum_q) : 64'(sum_q);
  end
  assign event_tiny_o       = tiny_q;
  assign event_tiny_area2_o = area2_q;

  assign idle_o = !edge_valid_q && !again_q && !add_1_q && !add_2_q && !end_1_q && !end_2_q && !tiny_q;

  `GNOMON_ASSERT_STREAM(a_edge_stable, edge_valid_o, edge_ready_i, {edge_from_q, edge_to_q, edge_first_q, edge_last_q})
  `GNOMON_ASSERT(a_edge_has_length,
                 !edge_valid_q || edge_last_q || edge_from_q[V-1:DEPTH_BITS] != edge_to_q[V-1:DEPTH_BITS])

endmodule
