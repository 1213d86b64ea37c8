// SPDX-License-Identifier: Apache-2.0
// Event counters of the silhouette-line buffer (docs/slb.md, "Commands"), in the order of gnomon_pkg::slb_events_t.

module slb_counters #(
  parameter bit EN_SNAPSHOT = 1'b0   // the last snapshot is read instead of the moment
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  logic                    snapshot_i,
  input  gnomon_pkg::slb_events_t events_i,
  input  logic [6:0]              number_i,
  output logic [63:0]             value_o    // 0 where there is no such counter
);

  localparam int unsigned COUNT = gnomon_pkg::SLB_COUNTER_COUNT;

  // 64 bits a counter, the first in the low bits.
  logic [COUNT*64-1:0] increments, values_q, shown;
  assign increments = {
    64'(events_i.query_overflow), 64'(events_i.query_off_plane), 64'(events_i.query_shadow), 64'(events_i.query),
    64'(events_i.cover_used), 64'(events_i.cover_sample), 64'(events_i.fill_covered), 64'(events_i.fill_group),
    64'(events_i.fill_pixels), 64'(events_i.winding_saturated), 64'(events_i.group_evicted),
    64'(events_i.chain_reduced), 64'(events_i.chain_dropped), 64'(events_i.chain_off_plane), 64'(events_i.chain),
    64'(events_i.crossing), 64'(events_i.vertex_repeated), 64'(events_i.vertex), events_i.tiny_area2,
    64'(events_i.loop_tiny), 64'(events_i.loop_short), 64'(events_i.loop), 64'(events_i.object)
  };

  for (genvar i = 0; i < COUNT; i++) begin : gen_counters
    always_ff @(posedge clk_i) begin
      if (!rst_ni)                          values_q[i*64+:64] <= '0;
      else if (increments[i*64+:64] != '0)  values_q[i*64+:64] <= values_q[i*64+:64] + increments[i*64+:64];
    end
  end

  counter_snapshot #(.WIDTH(COUNT * 64), .EN_SNAPSHOT(EN_SNAPSHOT)) u_snapshot (
    .clk_i, .rst_ni, .snapshot_i, .values_i(values_q), .shown_o(shown)
  );

  logic       exists;
  logic [6:0] number;
  assign exists  = number_i < 7'(COUNT);
  assign number  = exists ? number_i : '0;
  assign value_o = exists ? shown[32'(number)*64+:64] : 64'd0;

endmodule
