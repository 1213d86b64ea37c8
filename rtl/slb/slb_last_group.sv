// SPDX-License-Identifier: Apache-2.0
// The last group of an entry: its fragments, its depth, its chains. Combinational.

module slb_last_group #(
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned COUNT_BITS      = 2
) (
  input  logic                                  valid_i,   // else there is none
  input  logic [COUNT_BITS-1:0]                 count_i,
  input  logic [FRAGS_PER_PIXEL-1:0]            cont_i,
  input  logic [FRAGS_PER_PIXEL*2-1:0]          op_i,
  input  logic [FRAGS_PER_PIXEL*DEPTH_BITS-1:0] depth_i,
  output logic [FRAGS_PER_PIXEL-1:0]            member_o,  // a bit each fragment
  output logic [FRAGS_PER_PIXEL-1:0]            first_o,   // one bit, or none in an empty entry
  output logic [DEPTH_BITS-1:0]                 depth_o,   // the farthest
  output logic [3:0]                            chains_o   // 0..2 K
);

  localparam int unsigned D = DEPTH_BITS;

  logic done;
  always_comb begin
    member_o = '0;
    first_o  = '0;
    depth_o  = '0;
    chains_o = '0;
    done     = 1'b0;
    for (int i = FRAGS_PER_PIXEL - 1; i >= 0; i--) begin
      if (valid_i && COUNT_BITS'(i) < count_i && !done) begin
        member_o[i] = 1'b1;
        first_o[i]  = !cont_i[i];
        done        = !cont_i[i];
        if (depth_i[i*D+:D] > depth_o) depth_o = depth_i[i*D+:D];
        chains_o = chains_o + ((op_i[i*2+:2] == slb_pkg::FRAGMENT_TWO) ? 4'd2 : 4'd1);
      end
    end
  end

endmodule
