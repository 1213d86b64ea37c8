// SPDX-License-Identifier: Apache-2.0
// The caches of all units on one line port (docs/cache.md); a silent port without caches.

module core_line_port #(
  parameter int unsigned CACHE_LOG2      = 0,
  parameter bit          EN_SLB          = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY = 1'b0
) (
  input  logic                              clk_i,
  input  logic                              rst_ni,
  input  logic [63:12]                      plane_base_i,
  // Every unit's caches: the plane's, the silhouette-line buffer's two, topology mode's three.
  input  logic [cache_pkg::WANT-1:0]        plane_want_i,
  output logic [cache_pkg::GIVE-1:0]        plane_give_o,
  input  logic [2*cache_pkg::WANT-1:0]      slb_want_i,
  output logic [2*cache_pkg::GIVE-1:0]      slb_give_o,
  input  logic [3*cache_pkg::WANT-1:0]      lists_want_i,
  output logic [3*cache_pkg::GIVE-1:0]      lists_give_o,
  output logic                              line_read_valid_o,
  input  logic                              line_read_ready_i,
  output logic [63:6]                       line_read_address_o,
  output logic [2:0]                        line_read_id_o,
  input  logic                              line_data_valid_i,
  output logic                              line_data_ready_o,
  input  logic [2:0]                        line_data_id_i,
  input  logic [511:0]                      line_data_data_i,
  output logic                              line_write_valid_o,
  input  logic                              line_write_ready_i,
  output logic [63:6]                       line_write_address_o,
  output logic [2:0]                        line_write_id_o,
  output logic [511:0]                      line_write_data_o,
  output logic [63:0]                       line_write_strobe_o,
  input  logic                              line_written_valid_i,
  input  logic [2:0]                        line_written_id_i
);

  localparam int unsigned WANT = cache_pkg::WANT;
  localparam int unsigned GIVE = cache_pkg::GIVE;

  if (CACHE_LOG2 == 0) begin : gen_no_line_port
    assign plane_give_o         = '0;
    assign slb_give_o           = '0;
    assign lists_give_o         = '0;
    assign line_read_valid_o    = 1'b0;
    assign line_read_address_o  = '0;
    assign line_read_id_o       = '0;
    assign line_data_ready_o    = 1'b1;
    assign line_write_valid_o   = 1'b0;
    assign line_write_address_o = '0;
    assign line_write_id_o      = '0;
    assign line_write_data_o    = '0;
    assign line_write_strobe_o  = '0;
    logic unused_line;
    assign unused_line = ^{
      clk_i, rst_ni, plane_want_i, slb_want_i, lists_want_i, plane_base_i, line_read_ready_i, line_data_valid_i,
      line_data_id_i, line_data_data_i, line_write_ready_i, line_written_valid_i, line_written_id_i
    };
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
    cache_port #(.CLIENTS(CLIENTS)) u_port (
      .clk_i, .rst_ni, .base_i(plane_base_i), .want_i(want), .give_o(give), .line_read_valid_o, .line_read_ready_i,
      .line_read_address_o, .line_read_id_o, .line_data_valid_i, .line_data_ready_o,
      .line_data_id_i, .line_data_data_i, .line_write_valid_o, .line_write_ready_i, .line_write_address_o,
      .line_write_id_o, .line_write_data_o, .line_write_strobe_o, .line_written_valid_i, .line_written_id_i
    );
  end

endmodule
