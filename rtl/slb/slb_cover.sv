// SPDX-License-Identifier: Apache-2.0
// A sample of COVER against its entry (docs/slb.md, "COVER"). Combinational: the modify function of a read-modify-write.

module slb_cover #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  // Derived; not to be overridden.
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS)
) (
  input  logic                  valid_i,    // else nothing that comes out means anything
  input  logic [ENTRY-1:0]      entry_i,
  input  logic                  covered_i,  // of the pixel, from FILL
  input  logic                  rim_i,
  input  logic [DEPTH_BITS-1:0] front_i,    // of the sample: the range of its sheet in the pixel
  input  logic [DEPTH_BITS-1:0] depth_i,
  input  logic [DEPTH_BITS-1:0] margin_i,
  output logic [ENTRY-1:0]      entry_o,
  output logic                  used_o
);

  localparam int unsigned K  = FRAGS_PER_PIXEL;
  localparam int unsigned D  = DEPTH_BITS;
  localparam int unsigned CB = slb_pkg::count_bits(K);
  localparam int unsigned FB = slb_pkg::fragment_bits(FRAC_BITS, SLOPE_BITS, K, D);
  localparam int unsigned OB = slb_pkg::OBJECT_BITS;
  localparam int unsigned LOW = CB + 2 + slb_pkg::CORNER_BITS;  // bits below full_depth

  logic [K*FB-1:0] fragments;
  logic [D-1:0]    full_depth;
  logic [LOW-1:0]  low;
  assign {fragments, full_depth, low} = entry_i;

  logic [K-1:0]   cont, member, first;
  logic [K*2-1:0] op;
  logic [K*D-1:0] depth;
  logic [D-1:0]   rim_depth;
  logic [3:0]     chains;
  for (genvar i = 0; i < K; i++) begin : gen_fields
    assign depth[i*D+:D] = fragments[i*FB+:D];
    assign op[i*2+:2]    = fragments[i*FB+D+OB+:2];
    assign cont[i]       = fragments[i*FB+FB-1];
  end
  slb_last_group #(.FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .COUNT_BITS(CB)) u_group (
    .valid_i, .count_i(low[CB-1:0]), .cont_i(cont), .op_i(op), .depth_i(depth), .member_o(member), .first_o(first),
    .depth_o(rim_depth), .chains_o(chains)
  );

  // Fragments whose depth lies in the sheet's range. D + 1 bits: the sums do not wrap.
  logic [K-1:0] touched;
  for (genvar i = 0; i < K; i++) begin : gen_touched
    assign touched[i] = member[i] && (D + 1)'(front_i) <= (D + 1)'(depth[i*D+:D]) + (D + 1)'(margin_i) &&
                        (D + 1)'(depth[i*D+:D]) <= (D + 1)'(depth_i) + (D + 1)'(margin_i);
  end
  assign used_o  = covered_i && (!rim_i || touched == '0 || full_depth == '1);
  always_comb begin
    entry_o = 'x;
    if (valid_i) entry_o = {fragments, (used_o && depth_i < full_depth) ? depth_i : full_depth, low};
  end

  logic unused_group;
  assign unused_group = ^{first, chains, rim_depth};

endmodule
