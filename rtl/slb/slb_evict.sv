// SPDX-License-Identifier: Apache-2.0
// Which finished group has to go for a new object (docs/slb.md, "Store"): of the groups farther than the chain the farthest,
// of equal ones the later. Combinational.

module slb_evict #(
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned COUNT_BITS      = 2
) (
  input  logic                                  valid_i,    // else none has to
  input  logic [COUNT_BITS-1:0]                 count_i,
  input  logic [FRAGS_PER_PIXEL-1:0]            cont_i,
  input  logic [FRAGS_PER_PIXEL*DEPTH_BITS-1:0] depths_i,
  input  logic [DEPTH_BITS-1:0]                 depth_i,    // of the chain
  output logic                                  found_o,
  output logic [2:0]                            first_o,    // the group's first fragment
  output logic [2:0]                            length_o,   // and its number of fragments
  output logic [DEPTH_BITS-1:0]                 depth_o     // its depth
);

  localparam int unsigned D = DEPTH_BITS;

  // From the last fragment to the first: a group is complete at the fragment that does not continue another.
  logic [D-1:0] farthest;
  logic [2:0]   length;
  always_comb begin
    found_o  = 1'b0;
    first_o  = '0;
    length_o = '0;
    depth_o  = depth_i;
    farthest = '0;
    length   = '0;
    for (int i = FRAGS_PER_PIXEL - 1; i >= 0; i--) begin
      if (valid_i && COUNT_BITS'(i) < count_i) begin
        if (depths_i[i*D+:D] > farthest) farthest = depths_i[i*D+:D];
        length = length + 3'd1;
        if (!cont_i[i]) begin
          if (mutations_pkg::SLB_EVICT_EARLIER ? farthest >= depth_o && farthest > depth_i : farthest > depth_o) begin
            found_o  = 1'b1;
            first_o  = 3'(i);
            length_o = length;
            depth_o  = farthest;
          end
          farthest = '0;
          length   = '0;
        end
      end
    end
  end

endmodule
