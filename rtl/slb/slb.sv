// SPDX-License-Identifier: Apache-2.0
// Silhouette-line buffer unit (docs/slb.md): loops of vertices go through the front end, which walks them, into the back
// end, which keeps what they do in every pixel of its plane, and answers points.

`include "assertions.svh"

module slb #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned PLANE_LOG2      = 8,
  parameter int unsigned SUBPIXEL_BITS   = 10,
  parameter int unsigned QUERY_BITS      = 10,
  parameter int unsigned ROUNDING        = 0,
  parameter int unsigned DIVIDERS        = 2,
  parameter int unsigned MEM_LATENCY     = 1,
  parameter int unsigned MEM_STALL_SEED  = 0,
  parameter int unsigned CACHE_LOG2      = 0,  // not 0: entries in memory, behind caches (docs/cache.md)
  parameter int unsigned LINE_IDS_LOG2   = 4,
  parameter int unsigned FIRST_LINE      = 0   // there
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  // A command of this unit, good and in its place, begins with header `word_i`; its items follow as `word_i`. Another kind
  // of command begins only while the unit is idle.
  input  logic                    start_i,
  input  logic                    item_valid_i,
  output logic                    item_ready_o,
  input  logic [63:0]             word_i,
  // The loop ends: after the last item of LOOP without MORE.
  input  logic                    close_valid_i,
  output logic                    close_ready_o,
  // SLB_ANSWER words, and entries as read back.
  output logic                    result_valid_o,
  input  logic                    result_ready_i,
  output logic [63:0]             result_o,
  output logic                    idle_o,          // without another word nothing more happens
  output logic                    step_o,          // one step of a walk, a clear, a fill or a read
  output logic                    wait_o,          // a memory holds something back
  output gnomon_pkg::slb_events_t events_o,
  // Line port of the caches: lanes, then fragments in the upper half.
  output logic [2*cache_pkg::WANT-1:0] cache_want_o,
  input  logic [2*cache_pkg::GIVE-1:0] cache_give_i,
  output logic [2*cache_pkg::EVENTS-1:0]        cache_events_o
);

  localparam int unsigned D = DEPTH_BITS;
  localparam int unsigned C = PLANE_LOG2 + 2;     // bits of a column or row
  localparam int unsigned W = C + SUBPIXEL_BITS;  // bits of a vertex coordinate
  localparam int unsigned L = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS);

  // ---- The command in progress, and the object being drawn ----
  gnomon_pkg::header_t             header;
  logic [7:0]                      op_q;
  logic [slb_pkg::OBJECT_BITS-1:0] object_q;
  logic                            flat_q;
  logic [D-1:0]                    flat_depth_q;
  assign header = word_i;
  always_ff @(posedge clk_i) begin
    if (start_i) op_q <= header.op;
    if (start_i && header.op == gnomon_pkg::OP_BEGIN_OBJECT) begin
      object_q     <= header.arg[31-:slb_pkg::OBJECT_BITS];
      flat_q       <= (header.flags & gnomon_pkg::BEGIN_FLAT) != '0;
      flat_depth_q <= header.arg[D-1:0];
    end
  end

  // ---- Items by command ----
  logic vertex_ready, cover_ready, query_ready;
  always_comb begin
    case (op_q)
      gnomon_pkg::OP_COVER: item_ready_o = cover_ready;
      gnomon_pkg::OP_QUERY: item_ready_o = query_ready;
      default:              item_ready_o = vertex_ready;
    endcase
  end

  // ---- Front end ----
  logic                chain_valid, chain_ready, chain_corner, wind_valid, wind_ready, wind_up, outline_idle;
  logic signed [C-1:0] chain_column, chain_row, wind_column, wind_row;
  logic [1:0]          chain_op;
  logic [L-1:0]        chain_a, chain_b;
  logic [D-1:0]        chain_depth;
  logic                vertex, vertex_repeated, loop, loop_short, loop_tiny, crossing;
  logic [63:0]         tiny_area2;
  assign close_ready_o = vertex_ready;
  slb_outline #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2),
    .SUBPIXEL_BITS(SUBPIXEL_BITS), .ROUNDING(ROUNDING), .DIVIDERS(DIVIDERS)
  ) u_outline (
    .clk_i, .rst_ni, .in_valid_i(close_valid_i || (item_valid_i && op_q == gnomon_pkg::OP_LOOP)),
    .in_ready_o(vertex_ready), .in_close_i(close_valid_i), .in_x_i(word_i[0+:W]), .in_y_i(word_i[W+:W]),
    .in_depth_i(flat_q ? flat_depth_q : word_i[2*W+:D]), .chain_valid_o(chain_valid), .chain_ready_i(chain_ready),
    .chain_column_o(chain_column), .chain_row_o(chain_row), .chain_op_o(chain_op), .chain_a_o(chain_a),
    .chain_b_o(chain_b), .chain_corner_o(chain_corner), .chain_depth_o(chain_depth), .wind_valid_o(wind_valid),
    .wind_ready_i(wind_ready), .wind_column_o(wind_column), .wind_row_o(wind_row), .wind_up_o(wind_up),
    .event_vertex_o(vertex), .event_repeated_o(vertex_repeated), .event_loop_o(loop), .event_short_o(loop_short),
    .event_tiny_o(loop_tiny), .event_tiny_area2_o(tiny_area2), .event_crossing_o(crossing), .idle_o(outline_idle)
  );

  // ---- Back end ----
  logic                    backend_idle, backend_step;
  gnomon_pkg::slb_events_t events;
  slb_backend #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(FRAGS_PER_PIXEL), .DEPTH_BITS(D),
    .PLANE_LOG2(PLANE_LOG2), .QUERY_BITS(QUERY_BITS), .ROUNDING(ROUNDING), .MEM_LATENCY(MEM_LATENCY),
    .MEM_STALL_SEED(MEM_STALL_SEED), .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .FIRST_LINE(FIRST_LINE)
  ) u_backend (
    .clk_i, .rst_ni, .start_i, .header_i(header), .object_i(object_q), .flat_i(flat_q), .flat_depth_i(flat_depth_q),
    .cover_valid_i(item_valid_i && op_q == gnomon_pkg::OP_COVER), .cover_ready_o(cover_ready),
    .query_valid_i(item_valid_i && op_q == gnomon_pkg::OP_QUERY), .query_ready_o(query_ready), .item_i(word_i),
    .chain_valid_i(chain_valid), .chain_ready_o(chain_ready), .chain_column_i(chain_column), .chain_row_i(chain_row),
    .chain_op_i(chain_op), .chain_a_i(chain_a), .chain_b_i(chain_b), .chain_corner_i(chain_corner),
    .chain_depth_i(chain_depth), .wind_valid_i(wind_valid), .wind_ready_o(wind_ready), .wind_column_i(wind_column),
    .wind_row_i(wind_row), .wind_up_i(wind_up), .result_valid_o, .result_ready_i, .result_o,
    .idle_o(backend_idle), .step_o(backend_step), .wait_o, .events_o(events),
    .cache_want_o, .cache_give_i, .cache_events_o
  );

  assign idle_o = outline_idle && backend_idle;
  assign step_o = crossing || backend_step;
  always_comb begin
    events_o                 = events;
    events_o.loop            = loop;
    events_o.loop_short      = loop_short;
    events_o.loop_tiny       = loop_tiny;
    events_o.tiny_area2      = loop_tiny ? tiny_area2 : '0;
    events_o.vertex          = vertex;
    events_o.vertex_repeated = vertex_repeated;
    events_o.crossing        = crossing;
  end

  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
