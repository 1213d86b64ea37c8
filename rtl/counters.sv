// SPDX-License-Identifier: Apache-2.0
// Event and cycle counters with one read port (docs/command-stream.md, "Counters"; indices in gnomon_pkg).

module counters #(
  parameter bit EN_PERSPECTIVE  = 1'b0,
  parameter bit EN_VPU_TOPOLOGY = 1'b0,
  parameter bit EN_FRAME_BUFFER = 1'b0,
  parameter bit EN_SLB          = 1'b0
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  gnomon_pkg::events_t            events_i,
  input  gnomon_pkg::perspective_events_t perspective_events_i,
  input  topology_pkg::topology_events_t topology_events_i,
  input  frame_pkg::frame_events_t       frame_events_i,
  input  gnomon_pkg::slb_events_t        slb_events_i,
  input  gnomon_pkg::sticky_t            sticky_i,
  input  logic [3:0]                     pass_i,
  input  logic [2:0]                     cause_i,
  input  logic [7:0]                     index_i,
  output logic [63:0]                    value_o
);

  // ---- Events ----
  logic [63:0] commands_q, errors_q, projected_q, off_plane_q, saturated_q, writes_q;
  logic [63:0] resolved_q, facing_away_q, uncertain_q, offset_empty_q, shadow_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      commands_q     <= '0;
      errors_q       <= '0;
      projected_q    <= '0;
      off_plane_q    <= '0;
      saturated_q    <= '0;
      writes_q       <= '0;
      resolved_q     <= '0;
      facing_away_q  <= '0;
      uncertain_q    <= '0;
      offset_empty_q <= '0;
      shadow_q       <= '0;
    end else begin
      if (events_i.command)               commands_q     <= commands_q + 64'd1;
      if (events_i.error)                 errors_q       <= errors_q + 64'd1;
      if (events_i.voxel_projected)       projected_q    <= projected_q + 64'd1;
      if (events_i.project_off_plane)     off_plane_q    <= off_plane_q + 64'd1;
      if (events_i.project_saturated)     saturated_q    <= saturated_q + 64'd1;
      if (events_i.plane_write)           writes_q       <= writes_q + 64'd1;
      if (events_i.voxel_resolved)        resolved_q     <= resolved_q + 64'd1;
      if (events_i.resolved_facing_away)  facing_away_q  <= facing_away_q + 64'd1;
      if (events_i.resolved_uncertain)    uncertain_q    <= uncertain_q + 64'd1;
      if (events_i.resolved_offset_empty) offset_empty_q <= offset_empty_q + 64'd1;
      if (events_i.resolved_shadow)       shadow_q       <= shadow_q + 64'd1;
    end
  end

  // ---- Cycles: one of 60 counters moves in a cycle, so they are a RAM; a bit each says that it has counted since reset ----
  localparam int unsigned CELLS     = gnomon_pkg::PASS_COUNT * gnomon_pkg::CAUSE_COUNT;
  localparam int unsigned CELL_BITS = $clog2(CELLS);

  logic [63:0]          cycles_q [CELLS];
  logic [CELLS-1:0]     counted_q;
  logic [CELL_BITS-1:0] cell_now;
  assign cell_now = CELL_BITS'(pass_i) * CELL_BITS'(gnomon_pkg::CAUSE_COUNT) + CELL_BITS'(cause_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni) counted_q <= '0;
    else         counted_q[cell_now] <= 1'b1;
  end
  always_ff @(posedge clk_i) begin
    cycles_q[cell_now] <= (counted_q[cell_now] ? cycles_q[cell_now] : 64'd0) + 64'd1;
  end

  // ---- Events of the frame buffer, in the upper half of the indices; all others in the lower one ----
  logic        upper;
  logic [6:0]  index;
  logic [63:0] frame_value;
  assign {upper, index} = index_i;
  if (EN_FRAME_BUFFER) begin : gen_frame
    event_counters #(.COUNT(frame_pkg::COUNTER_COUNT)) u_frame (
      .clk_i, .rst_ni, .events_i(frame_events_i), .number_i(index), .value_o(frame_value)
    );
  end else begin : gen_no_frame
    logic unused_frame;
    assign unused_frame = ^frame_events_i;
    assign frame_value  = '0;
  end

  // ---- Events of the silhouette-line buffer ----
  logic [6:0]  slb_number;
  logic [63:0] slb_value;
  assign slb_number = index - gnomon_pkg::COUNTER_SLB;
  if (EN_SLB) begin : gen_slb
    slb_counters u_slb (.clk_i, .rst_ni, .events_i(slb_events_i), .number_i(slb_number), .value_o(slb_value));
  end else begin : gen_no_slb
    logic unused_slb;
    assign unused_slb = ^{slb_events_i, slb_number};
    assign slb_value  = '0;
  end

  // ---- Events of topology mode ----
  logic [6:0]  topology_number;
  logic [63:0] topology_value;
  assign topology_number = index - gnomon_pkg::COUNTER_TOPOLOGY;
  if (EN_VPU_TOPOLOGY) begin : gen_topology
    event_counters #(.COUNT(topology_pkg::COUNTER_COUNT)) u_topology (
      .clk_i, .rst_ni, .events_i(topology_events_i), .number_i(topology_number), .value_o(topology_value)
    );
  end else begin : gen_no_topology
    logic unused_topology;
    assign unused_topology = ^{topology_events_i, topology_number};
    assign topology_value  = '0;
  end

  // ---- Events of the perspective projection: the first in the highest bit of the struct, the low bits of the values ----
  logic [63:0] perspective_value;
  if (EN_PERSPECTIVE) begin : gen_perspective
    localparam int unsigned COUNT = gnomon_pkg::PERSPECTIVE_COUNTER_COUNT;
    logic [COUNT-1:0]    perspective_events;
    logic [COUNT*64-1:0] values_q;
    logic [6:0]          number;
    assign perspective_events = perspective_events_i;
    assign number             = index - gnomon_pkg::COUNTER_PERSPECTIVE;
    for (genvar i = 0; i < COUNT; i++) begin : gen_counters
      always_ff @(posedge clk_i) begin
        if (!rst_ni)                            values_q[i*64+:64] <= '0;
        else if (perspective_events[COUNT-1-i]) values_q[i*64+:64] <= values_q[i*64+:64] + 64'd1;
      end
    end
    assign perspective_value = (number < 7'(COUNT)) ? values_q[32'(number)*64+:64] : 64'd0;
  end else begin : gen_no_perspective
    logic unused_perspective;
    assign unused_perspective = ^perspective_events_i;
    assign perspective_value  = '0;
  end

  // ---- Read port ----
  logic [6:0]           offset;
  logic [CELL_BITS-1:0] cell_read;
  logic                 is_cell;
  assign offset    = index - gnomon_pkg::COUNTER_CYCLES;
  assign is_cell   = index >= gnomon_pkg::COUNTER_CYCLES && offset < 7'(CELLS);
  assign cell_read = is_cell ? offset[CELL_BITS-1:0] : '0;

  logic [63:0] lower_value;
  assign value_o = upper ? frame_value : lower_value;
  always_comb begin
    case (index)
      gnomon_pkg::COUNTER_COMMANDS:              lower_value = commands_q;
      gnomon_pkg::COUNTER_ERRORS:                lower_value = errors_q;
      gnomon_pkg::COUNTER_VOXELS_PROJECTED:      lower_value = projected_q;
      gnomon_pkg::COUNTER_PROJECT_OFF_PLANE:     lower_value = off_plane_q;
      gnomon_pkg::COUNTER_PROJECT_SATURATED:     lower_value = saturated_q;
      gnomon_pkg::COUNTER_PLANE_WRITES:          lower_value = writes_q;
      gnomon_pkg::COUNTER_VOXELS_RESOLVED:       lower_value = resolved_q;
      gnomon_pkg::COUNTER_RESOLVED_FACING_AWAY:  lower_value = facing_away_q;
      gnomon_pkg::COUNTER_RESOLVED_UNCERTAIN:    lower_value = uncertain_q;
      gnomon_pkg::COUNTER_RESOLVED_OFFSET_EMPTY: lower_value = offset_empty_q;
      gnomon_pkg::COUNTER_RESOLVED_SHADOW:       lower_value = shadow_q;
      gnomon_pkg::COUNTER_STICKY:                lower_value = 64'(sticky_i);
      default: begin
        if (!is_cell)                   lower_value = slb_value | topology_value | perspective_value;  // at most one exists
        else if (counted_q[cell_read])  lower_value = cycles_q[cell_read];
        else                            lower_value = '0;
      end
    endcase
  end

endmodule
