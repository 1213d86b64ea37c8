// SPDX-License-Identifier: Apache-2.0
// From the lines that contain a point to the answer (docs/slb.md, "Query"). Combinational.

module slb_answer #(
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  // Derived; not to be overridden.
  parameter int unsigned COUNT_BITS     = slb_pkg::count_bits(FRAGS_PER_PIXEL),
  parameter int unsigned THRESHOLD_BITS = slb_pkg::threshold_bits(FRAGS_PER_PIXEL)
) (
  input  logic                                            valid_i,  // else there is nothing to find, and 0 is the answer
  input  logic [COUNT_BITS-1:0]                           count_i,
  input  logic [DEPTH_BITS-1:0]                           full_depth_i,
  // Fields of every fragment, and which of its lines contain the point.
  input  logic [FRAGS_PER_PIXEL*DEPTH_BITS-1:0]           depth_i,
  input  logic [FRAGS_PER_PIXEL*slb_pkg::OBJECT_BITS-1:0] object_i,
  input  logic [FRAGS_PER_PIXEL*2-1:0]                    op_i,
  input  logic [FRAGS_PER_PIXEL*THRESHOLD_BITS-1:0]       threshold_i,
  input  logic [FRAGS_PER_PIXEL-1:0]                      cont_i,
  input  logic [FRAGS_PER_PIXEL-1:0]                      in_a_i,
  input  logic [FRAGS_PER_PIXEL-1:0]                      in_b_i,
  // The point.
  input  logic [DEPTH_BITS-1:0]                           point_depth_i,
  input  logic [DEPTH_BITS-1:0]                           bias_i,
  output logic                                            by_full_o,
  output logic                                            by_lines_o,
  output logic [slb_pkg::OBJECT_BITS-1:0]                 object_o
);

  localparam int unsigned D  = DEPTH_BITS;
  localparam int unsigned TB = THRESHOLD_BITS;
  localparam int unsigned OB = slb_pkg::OBJECT_BITS;

  // D + 1 bits: the sums do not wrap.
  logic [D:0] point, bias;
  assign point     = (D + 1)'(point_depth_i);
  assign bias      = (D + 1)'(bias_i);
  assign by_full_o = valid_i && (D + 1)'(full_depth_i) + bias < point;

  // From the last fragment to the first: a group is complete at the fragment that does not continue another, and the first
  // group has the last word.
  logic [3:0]   chains;  // 0..2 K
  logic [D-1:0] farthest;
  always_comb begin
    by_lines_o = 1'b0;
    object_o   = '0;
    chains     = '0;
    farthest   = '0;
    if (valid_i) begin
      for (int i = FRAGS_PER_PIXEL - 1; i >= 0; i--) begin
        if (COUNT_BITS'(i) < count_i) begin
          case (op_i[i*2+:2])
            slb_pkg::FRAGMENT_ONE: chains = chains + 4'(in_a_i[i]);
            slb_pkg::FRAGMENT_AND: chains = chains + 4'(in_a_i[i] && in_b_i[i]);
            slb_pkg::FRAGMENT_OR:  chains = chains + 4'(in_a_i[i] || in_b_i[i]);
            default:               chains = chains + 4'(in_a_i[i]) + 4'(in_b_i[i]);
          endcase
          if (depth_i[i*D+:D] > farthest) farthest = depth_i[i*D+:D];
          if (!cont_i[i]) begin
            if (chains > 4'(threshold_i[i*TB+:TB]) && (D + 1)'(farthest) + bias < point) begin
              if (!by_lines_o || !mutations_pkg::SLB_LAST_OBJECT) object_o = object_i[i*OB+:OB];
              by_lines_o = 1'b1;
            end
            chains   = '0;
            farthest = '0;
          end
        end
      end
    end
  end

endmodule
