// SPDX-License-Identifier: Apache-2.0
// FILL of a pixel with lines (docs/slb.md, "Winding and FILL"): the threshold of the object's group, or its removal.
// Combinational: the modify function of a read-modify-write.

module slb_finish #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned WINDING_BITS    = 17,  // p + 9
  parameter int unsigned ROUNDING        = 0,
  // Derived; not to be overridden.
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS)
) (
  input  logic                           valid_i,    // else nothing that comes out means anything
  input  logic [ENTRY-1:0]               entry_i,
  input  logic [FRAGS_PER_PIXEL-1:0]     centre_i,
  input  logic signed [WINDING_BITS-1:0] winding_i,  // W at the lower left corner
  input  logic                           flat_i,
  input  logic [DEPTH_BITS-1:0]          depth_i,    // of a flat object
  output logic [ENTRY-1:0]               entry_o,
  output logic [FRAGS_PER_PIXEL-1:0]     centre_o,
  output logic                           covered_o,
  output logic                           rim_o
);

  localparam int unsigned K  = FRAGS_PER_PIXEL;
  localparam int unsigned D  = DEPTH_BITS;
  localparam int unsigned L  = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS);
  localparam int unsigned CB = slb_pkg::count_bits(K);
  localparam int unsigned TB = slb_pkg::threshold_bits(K);
  localparam int unsigned R  = slb_pkg::CORNER_BITS;
  localparam int unsigned FB = slb_pkg::fragment_bits(FRAC_BITS, SLOPE_BITS, K, D);
  localparam int unsigned OB = slb_pkg::OBJECT_BITS;

  // ---- Fields ----
  logic [K*FB-1:0]     fragments;
  logic [D-1:0]        full_depth;
  logic signed [R-1:0] corner;
  logic                open, overflow;
  logic [CB-1:0]       count;
  assign {fragments, full_depth, corner, open, overflow, count} = entry_i;

  logic [K-1:0]   cont, in_a, in_b;
  logic [K*2-1:0] op;
  logic [K*D-1:0] depth;
  for (genvar i = 0; i < K; i++) begin : gen_fields
    assign depth[i*D+:D] = fragments[i*FB+:D];
    assign op[i*2+:2]    = fragments[i*FB+D+OB+:2];
    assign cont[i]       = fragments[i*FB+FB-1];
    slb_line_centre #(.FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .ROUNDING(ROUNDING)) u_a (
      .valid_i, .line_i(fragments[i*FB+D+OB+2+:L]), .contains_o(in_a[i])
    );
    slb_line_centre #(.FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .ROUNDING(ROUNDING)) u_b (
      .valid_i, .line_i(fragments[i*FB+D+OB+2+L+:L]), .contains_o(in_b[i])
    );
  end

  logic [K-1:0] member, first;
  logic [D-1:0] group_depth;
  logic [3:0]   chains;
  slb_last_group #(.FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .COUNT_BITS(CB)) u_group (
    .valid_i, .count_i(count), .cont_i(cont), .op_i(op), .depth_i(depth), .member_o(member), .first_o(first),
    .depth_o(group_depth), .chains_o(chains)
  );

  // ---- Threshold: T = 1 - W + corner, a bit more than W has ----
  localparam int unsigned T = WINDING_BITS + 1;
  logic signed [T-1:0] threshold;
  logic                keeps;
  assign threshold = T'(1) - T'(winding_i) + T'(corner);
  assign covered_o = threshold <= 0;
  assign keeps     = open && (covered_o ? !flat_i : threshold <= signed'(T'(chains)));
  assign rim_o     = keeps;

  logic [TB-1:0] code;  // T - 1; 0 where the pixel is covered
  assign code = covered_o ? '0 : TB'(threshold - T'(1));

  // ---- The group's answer at the centre, for an eviction later on ----
  logic [3:0] containing;
  always_comb begin
    containing = '0;
    for (int i = 0; i < K; i++) begin
      if (member[i]) begin
        case (op[i*2+:2])
          slb_pkg::FRAGMENT_ONE: containing = containing + 4'(in_a[i]);
          slb_pkg::FRAGMENT_AND: containing = containing + 4'(in_a[i] && in_b[i]);
          slb_pkg::FRAGMENT_OR:  containing = containing + 4'(in_a[i] || in_b[i]);
          default:               containing = containing + 4'(in_a[i]) + 4'(in_b[i]);
        endcase
      end
    end
  end

  logic [K*FB-1:0] new_fragments;
  logic [2:0]      removed;
  always_comb begin
    new_fragments = 'x;
    centre_o      = 'x;
    removed       = '0;
    if (valid_i) begin
      new_fragments = fragments;
      centre_o      = centre_i;
      for (int i = 0; i < K; i++) begin
        if (open && member[i] && !keeps) begin
          new_fragments[i*FB+:FB] = '0;
          removed                 = removed + 3'd1;
        end else if (open && first[i]) begin
          new_fragments[i*FB+FB-2-:TB] = code;
          centre_o[i]                  = containing > 4'(code);  // at least T of its chains
        end
      end
    end
  end

  logic [D-1:0]  new_full_depth;
  assign new_full_depth = (covered_o && flat_i && depth_i < full_depth) ? depth_i : full_depth;
  always_comb begin
    entry_o = 'x;
    if (valid_i) entry_o = {new_fragments, new_full_depth, R'(0), 1'b0, overflow, CB'(3'(count) - removed)};
  end

  logic unused_group;
  assign unused_group = ^group_depth;

endmodule
