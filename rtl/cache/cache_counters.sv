// SPDX-License-Identifier: Apache-2.0
// Event counters of the caches that are built: eight indices for each memory, of which the first six are used.

module cache_counters #(
  parameter logic [cache_pkg::MEMORIES-1:0] BUILT       = '0,   // memories that have a cache
  parameter bit                             EN_SNAPSHOT = 1'b0
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,
  input  logic                                                  snapshot_i,
  input  logic [cache_pkg::MEMORIES*cache_pkg::EVENTS-1:0]      events_i,  // memory 0 lowest
  input  logic [6:0]                                            number_i,
  output logic [63:0]                                           value_o    // 0 where there is no such counter
);

  localparam int unsigned MEMORIES = cache_pkg::MEMORIES;
  localparam int unsigned EVENTS   = cache_pkg::EVENTS;

  logic [MEMORIES*64-1:0] values;
  for (genvar i = 0; i < MEMORIES; i++) begin : gen_memories
    if (BUILT[i]) begin : gen_counters
      logic [6:0] number;
      assign number = number_i - 7'(8 * i);
      event_counters #(.COUNT(EVENTS), .EN_SNAPSHOT(EN_SNAPSHOT)) u_events (
        .clk_i, .rst_ni, .snapshot_i, .events_i(events_i[i*EVENTS+:EVENTS]), .number_i(number),
        .value_o(values[i*64+:64])
      );
    end else begin : gen_none
      logic unused_events;
      assign unused_events     = ^events_i[i*EVENTS+:EVENTS];
      assign values[i*64+:64] = '0;
    end
  end
  always_comb begin
    value_o = '0;
    for (int i = 0; i < MEMORIES; i++) value_o = value_o | values[i*64+:64];
  end

  logic unused_inputs;
  assign unused_inputs = ^{clk_i, rst_ni, snapshot_i, number_i};

endmodule
