// SPDX-License-Identifier: Apache-2.0
// The caches of all units on one line port (docs/cache.md); a silent port without caches.

module core_line_port #(
  parameter int unsigned CACHE_LOG2      = 0,
  parameter int unsigned LINE_IDS_LOG2   = 4,
  parameter bit          EN_SLB          = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY = 1'b0
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic [63:12]                 plane_base_i,
  // Every unit's caches: the plane's, the silhouette-line buffer's two, topology mode's three.
  input  logic [cache_pkg::WANT-1:0]   plane_want_i,
  output logic [cache_pkg::GIVE-1:0]   plane_give_o,
  input  logic [2*cache_pkg::WANT-1:0] slb_want_i,
  output logic [2*cache_pkg::GIVE-1:0] slb_give_o,
  input  logic [3*cache_pkg::WANT-1:0] lists_want_i,
  output logic [3*cache_pkg::GIVE-1:0] lists_give_o,
  output cache_pkg::port_want_t        port_o,
  input  cache_pkg::port_give_t        port_i
);

  localparam int unsigned WANT = cache_pkg::WANT;
  localparam int unsigned GIVE = cache_pkg::GIVE;

  if (CACHE_LOG2 == 0) begin : gen_no_line_port
    assign plane_give_o = '0;
    assign slb_give_o   = '0;
    assign lists_give_o = '0;
    assign port_o       = '0;
    logic unused_line;
    assign unused_line = ^{clk_i, rst_ni, plane_want_i, slb_want_i, lists_want_i, plane_base_i, port_i} ^
                         (LINE_IDS_LOG2 == 0);
  end else begin : gen_line_port
    localparam int unsigned CLIENTS = 1 + (EN_SLB ? 2 : 0) + (EN_VPU_TOPOLOGY ? 3 : 0);
    logic [CLIENTS*WANT-1:0] want;
    logic [CLIENTS*GIVE-1:0] give;
    assign want[0+:WANT] = plane_want_i;
    assign plane_give_o  = give[0+:GIVE];
    if (EN_SLB) begin : gen_slb_port
      assign want[WANT+:2*WANT] = slb_want_i;
      assign slb_give_o         = give[GIVE+:2*GIVE];
    end else begin : gen_no_slb_port
      logic unused_want;
      assign unused_want = ^slb_want_i;
      assign slb_give_o  = '0;
    end
    if (EN_VPU_TOPOLOGY) begin : gen_lists_port
      assign want[(CLIENTS-3)*WANT+:3*WANT] = lists_want_i;
      assign lists_give_o                   = give[(CLIENTS-3)*GIVE+:3*GIVE];
    end else begin : gen_no_lists_port
      logic unused_want;
      assign unused_want  = ^lists_want_i;
      assign lists_give_o = '0;
    end
    cache_port #(.CLIENTS(CLIENTS), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_port (
      .clk_i, .rst_ni, .base_i(plane_base_i), .want_i(want), .give_o(give), .port_o, .port_i
    );
  end

endmodule
