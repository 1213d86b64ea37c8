// SPDX-License-Identifier: Apache-2.0
// Event and cycle counters with one read port (docs/command-stream.md, "Counters"; indices in gnomon_pkg).

module counters #(
  parameter bit EN_PERSPECTIVE  = 1'b0,
  parameter bit EN_VPU_TOPOLOGY = 1'b0,
  parameter bit EN_FRAME_BUFFER = 1'b0,
  parameter bit EN_SLB          = 1'b0,
  parameter logic [cache_pkg::MEMORIES-1:0] CACHES = '0,  // memories behind a cache
  parameter bit EN_SNAPSHOT     = 1'b0    // the last snapshot is read instead of the moment
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic                            snapshot_i,
  input  gnomon_pkg::events_t             events_i,
  input  gnomon_pkg::perspective_events_t perspective_events_i,
  input  topology_pkg::topology_events_t  topology_events_i,
  input  frame_pkg::frame_events_t        frame_events_i,
  input  gnomon_pkg::slb_events_t         slb_events_i,
  input  logic [cache_pkg::MEMORIES*cache_pkg::EVENTS-1:0] cache_events_i,  // memory 0 lowest
  input  gnomon_pkg::sticky_t             sticky_i,
  input  logic [3:0]                      pass_i,
  input  logic [2:0]                      cause_i,
  input  logic [7:0]                      index_i,
  output logic [63:0]                     value_o
);

  // Frame buffer and caches in the upper half of the indices, all others in the lower one.
  logic       upper;
  logic [6:0] index;
  assign {upper, index} = index_i;

  // ---- What every build has: events, sticky flags, cycles ----
  logic [63:0]         event_value, cycle_value;
  logic [6:0]          cycle_number;
  gnomon_pkg::sticky_t sticky;
  event_counters #(.COUNT(gnomon_pkg::EVENT_COUNTER_COUNT), .EN_SNAPSHOT(EN_SNAPSHOT)) u_events (
    .clk_i, .rst_ni, .snapshot_i, .events_i(events_i), .number_i(index), .value_o(event_value)
  );
  counter_snapshot #(.WIDTH(gnomon_pkg::STICKY_BITS), .EN_SNAPSHOT(EN_SNAPSHOT)) u_sticky (
    .clk_i, .rst_ni, .snapshot_i, .values_i(sticky_i), .shown_o(sticky)
  );
  assign cycle_number = index - gnomon_pkg::COUNTER_CYCLES;
  cycle_counters #(.EN_SNAPSHOT(EN_SNAPSHOT)) u_cycles (
    .clk_i, .rst_ni, .snapshot_i, .pass_i, .cause_i, .number_i(cycle_number), .value_o(cycle_value)
  );

  // ---- Frame buffer ----
  logic [63:0] frame_value;
  if (EN_FRAME_BUFFER) begin : gen_frame
    event_counters #(.COUNT(frame_pkg::COUNTER_COUNT), .EN_SNAPSHOT(EN_SNAPSHOT)) u_frame (
      .clk_i, .rst_ni, .snapshot_i, .events_i(frame_events_i), .number_i(index), .value_o(frame_value)
    );
  end else begin : gen_no_frame
    logic unused_frame;
    assign unused_frame = ^frame_events_i;
    assign frame_value  = '0;
  end

  // ---- Caches ----
  logic [6:0]  cache_number;
  logic [63:0] cache_value;
  assign cache_number = index - cache_pkg::COUNTER_NUMBER;
  cache_counters #(.BUILT(CACHES), .EN_SNAPSHOT(EN_SNAPSHOT)) u_caches (
    .clk_i, .rst_ni, .snapshot_i, .events_i(cache_events_i), .number_i(cache_number), .value_o(cache_value)
  );

  // ---- Silhouette-line buffer ----
  logic [6:0]  slb_number;
  logic [63:0] slb_value;
  assign slb_number = index - gnomon_pkg::COUNTER_SLB;
  if (EN_SLB) begin : gen_slb
    slb_counters #(.EN_SNAPSHOT(EN_SNAPSHOT)) u_slb (
      .clk_i, .rst_ni, .snapshot_i, .events_i(slb_events_i), .number_i(slb_number), .value_o(slb_value)
    );
  end else begin : gen_no_slb
    logic unused_slb;
    assign unused_slb = ^{slb_events_i, slb_number};
    assign slb_value  = '0;
  end

  // ---- Topology mode ----
  logic [6:0]  topology_number;
  logic [63:0] topology_value;
  assign topology_number = index - gnomon_pkg::COUNTER_TOPOLOGY;
  if (EN_VPU_TOPOLOGY) begin : gen_topology
    event_counters #(.COUNT(topology_pkg::COUNTER_COUNT), .EN_SNAPSHOT(EN_SNAPSHOT)) u_topology (
      .clk_i, .rst_ni, .snapshot_i, .events_i(topology_events_i), .number_i(topology_number), .value_o(topology_value)
    );
  end else begin : gen_no_topology
    logic unused_topology;
    assign unused_topology = ^{topology_events_i, topology_number};
    assign topology_value  = '0;
  end

  // ---- Perspective projection ----
  logic [6:0]  perspective_number;
  logic [63:0] perspective_value;
  assign perspective_number = index - gnomon_pkg::COUNTER_PERSPECTIVE;
  if (EN_PERSPECTIVE) begin : gen_perspective
    event_counters #(.COUNT(gnomon_pkg::PERSPECTIVE_COUNTER_COUNT), .EN_SNAPSHOT(EN_SNAPSHOT)) u_perspective (
      .clk_i, .rst_ni, .snapshot_i, .events_i(perspective_events_i), .number_i(perspective_number),
      .value_o(perspective_value)
    );
  end else begin : gen_no_perspective
    logic unused_perspective;
    assign unused_perspective = ^{perspective_events_i, perspective_number};
    assign perspective_value  = '0;
  end

  // ---- Read port: at most one of the values exists ----
  logic [63:0] sticky_value, lower_value;
  assign sticky_value = (index == gnomon_pkg::COUNTER_STICKY) ? 64'(sticky) : 64'd0;
  assign lower_value  = event_value | sticky_value | cycle_value | slb_value | topology_value | perspective_value;
  assign value_o      = upper ? (frame_value | cache_value) : lower_value;

endmodule
