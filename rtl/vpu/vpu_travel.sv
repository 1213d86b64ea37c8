// SPDX-License-Identifier: Apache-2.0
// What travels with an item through the stages of the front end: that there is one, what it is for, its command's arguments.
// All of it moves when the stages do. After its place an item goes on only if it is to be resolved.

module vpu_travel #(
  parameter bit          EN_VPU_TOPOLOGY = 1'b1,
  parameter int unsigned CLEARANCE       = 24,
  // Stages: of the place, of the offset point, of the turned gradient.
  parameter int unsigned PLACED          = 11,
  parameter int unsigned MOVED           = PLACED + 2,
  parameter int unsigned TURNED          = 4
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  en_i,
  input  logic                                  item_valid_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0] kind_i,
  input  logic                                  two_sided_i,
  input  logic                                  sorted_i,
  input  logic [CLEARANCE-1:0]                  clearance_i,
  output logic                                  idle_o,            // nothing in any stage
  output logic                                  two_sided_o,       // in the cycle before stage TURNED
  output logic                                  beam3_o,           // in stage 3
  output logic [CLEARANCE-1:0]                  clearance3_o,
  output logic                                  valid_o,           // in stage PLACED
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0] kind_o,
  output logic                                  moved_valid_o,     // in stage MOVED
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0] moved_kind_o,
  output logic                                  sorted_o,
  output logic [CLEARANCE-1:0]                  moved_clearance_o
);

  // Bit s: stage s.
  localparam int unsigned K = gnomon_pkg::ITEM_KIND_BITS;
  logic [MOVED:0]         valid_q;
  logic [(MOVED+1)*K-1:0] kinds_q;
  logic [TURNED-1:0]      two_sided_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
    end else if (en_i) begin
      valid_q           <= {valid_q[MOVED-1:0], item_valid_i};
      valid_q[PLACED+1] <= valid_q[PLACED] && gnomon_pkg::is_resolved(kind_o);
    end
  end
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      kinds_q     <= {kinds_q[MOVED*K-1:0], kind_i};
      two_sided_q <= {two_sided_q[TURNED-2:0], two_sided_i};
    end
  end
  assign idle_o        = valid_q == '0;
  assign two_sided_o   = two_sided_q[TURNED-1];
  assign beam3_o       = kinds_q[3*K+:K] == gnomon_pkg::ITEM_BEAM;
  assign valid_o       = valid_q[PLACED];
  assign kind_o        = kinds_q[PLACED*K+:K];
  assign moved_valid_o = valid_q[MOVED];
  assign moved_kind_o  = kinds_q[MOVED*K+:K];

  if (EN_VPU_TOPOLOGY) begin : gen_arguments
    logic sorted3;
    vpu_delay #(.WIDTH(1 + CLEARANCE), .CYCLES(4)) u_early (
      .clk_i, .rst_ni, .en_i, .data_i({sorted_i, clearance_i}), .data_o({sorted3, clearance3_o})
    );
    vpu_delay #(.WIDTH(1 + CLEARANCE), .CYCLES(MOVED - 3)) u_late (
      .clk_i, .rst_ni, .en_i, .data_i({sorted3, clearance3_o}), .data_o({sorted_o, moved_clearance_o})
    );
  end else begin : gen_no_arguments
    assign clearance3_o      = '0;
    assign moved_clearance_o = '0;
    assign sorted_o          = 1'b0;
    logic unused_arguments;
    assign unused_arguments = ^{sorted_i, clearance_i};
  end

endmodule
