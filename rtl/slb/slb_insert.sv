// SPDX-License-Identifier: Apache-2.0
// Puts a chain into an entry (docs/slb.md, "Store"). Combinational: the modify function of a read-modify-write, so that
// consecutive chains of a pixel each see the entry as the one before left it.

module slb_insert #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  // Derived; not to be overridden.
  parameter int unsigned LINE  = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS),
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS)
) (
  input  logic                             valid_i,     // else nothing that comes out means anything
  input  logic [ENTRY-1:0]                 entry_i,
  input  logic [FRAGS_PER_PIXEL-1:0]       centre_i,    // in a finished group's first fragment: it covers the centre
  // The chain.
  input  logic [DEPTH_BITS-1:0]            depth_i,
  input  logic [slb_pkg::OBJECT_BITS-1:0]  object_i,
  input  logic [1:0]                       op_i,
  input  logic [LINE-1:0]                  a_i,
  input  logic [LINE-1:0]                  b_i,
  input  logic [LINE-1:0]                  join_i,      // what it becomes as the second chain of a fragment
  input  logic                             contains_i,  // the chain contains the centre
  input  logic                             corner_i,    // its corner bit
  output logic [ENTRY-1:0]                 entry_o,
  output logic [FRAGS_PER_PIXEL-1:0]       centre_o,
  output logic                             dropped_o,
  output logic                             reduced_o,
  output logic                             evicted_o
);

  localparam int unsigned K  = FRAGS_PER_PIXEL;
  localparam int unsigned D  = DEPTH_BITS;
  localparam int unsigned CB = slb_pkg::count_bits(K);
  localparam int unsigned TB = slb_pkg::threshold_bits(K);
  localparam int unsigned R  = slb_pkg::CORNER_BITS;
  localparam int unsigned FB = slb_pkg::fragment_bits(FRAC_BITS, SLOPE_BITS, K, D);
  localparam int unsigned OB = slb_pkg::OBJECT_BITS;

  // ---- Fields ----
  logic [K*FB-1:0]       fragments;
  logic [D-1:0]          full_depth;
  logic signed [R-1:0]   corner;
  logic                  open, overflow;
  logic [CB-1:0]         count;
  assign {fragments, full_depth, corner, open, overflow, count} = entry_i;

  logic [K-1:0]   cont;
  logic [K*2-1:0] op;
  logic [K*D-1:0] depth;
  for (genvar i = 0; i < K; i++) begin : gen_fields
    assign depth[i*D+:D] = fragments[i*FB+:D];
    assign op[i*2+:2]    = fragments[i*FB+D+OB+:2];
    assign cont[i]       = fragments[i*FB+FB-1];
  end

  // ---- A free place: the first fragment of the open group with one line ----
  logic [K-1:0] member, first, free;
  logic [D-1:0] group_depth;
  logic [3:0]   chains;
  slb_last_group #(.FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .COUNT_BITS(CB)) u_group (
    .valid_i, .count_i(count), .cont_i(cont), .op_i(op), .depth_i(depth), .member_o(member), .first_o(first),
    .depth_o(group_depth), .chains_o(chains)
  );
  logic found;
  always_comb begin
    free  = '0;
    found = 1'b0;
    for (int i = 0; i < K; i++) begin
      free[i] = open && member[i] && op[i*2+:2] == slb_pkg::FRAGMENT_ONE && !found;
      found   = found || free[i];
    end
  end

  // ---- Room: a place at the end, or that of an older group ----
  logic         full, farther, evict;
  logic [2:0]   evict_first, evict_length;
  logic [D-1:0] evict_depth;
  slb_evict #(.FRAGS_PER_PIXEL(K), .DEPTH_BITS(D), .COUNT_BITS(CB)) u_evict (
    .valid_i, .count_i(count), .cont_i(cont), .depths_i(depth), .depth_i, .found_o(farther), .first_o(evict_first),
    .length_o(evict_length), .depth_o(evict_depth)
  );
  assign full  = count == CB'(K);
  assign evict = full && !open && farther;

  // ---- What becomes of the chain ----
  logic one, join_chain, append, kept_answer;
  assign one        = op_i == slb_pkg::FRAGMENT_ONE;
  assign append     = !(one && found) && (!full || evict);
  assign join_chain = found && !append;
  assign dropped_o  = !append && !join_chain;
  assign reduced_o  = join_chain && !one;
  assign evicted_o  = evict;

  // ---- Fragments: later ones move down, then the chain joins one or follows them ----
  logic [2:0]      from, place;
  logic [K*FB-1:0] new_fragments;
  logic [FB-1:0]   fragment;
  assign place = 3'(count) - (evict ? evict_length : 3'd0);
  always_comb begin
    kept_answer   = 1'b0;
    from          = '0;
    fragment      = '0;
    new_fragments = 'x;
    centre_o      = 'x;
    if (valid_i) begin
      for (int i = 0; i < K; i++) begin
        // Where fragment i comes from.
        from        = (evict && 3'(i) >= evict_first) ? 3'(i) + evict_length : 3'(i);
        fragment    = '0;
        centre_o[i] = 1'b0;
        for (int j = i; j < K; j++) begin
          if (from == 3'(j)) begin
            fragment    = fragments[j*FB+:FB];
            centre_o[i] = centre_i[j];
          end
        end
        if (evict && evict_first == 3'(i)) kept_answer = centre_i[i] && !mutations_pkg::SLB_FORGET_CENTRE;
        if (append && place == 3'(i)) begin
          fragment    = {open, TB'(0), b_i, a_i, op_i, object_i, depth_i};
          centre_o[i] = 1'b0;
        end
        if (join_chain && free[i]) begin
          fragment[D+OB+2+LINE+:LINE] = join_i;
          fragment[D+OB+:2]           = slb_pkg::FRAGMENT_TWO;
          if (depth_i > fragment[0+:D]) fragment[0+:D] = depth_i;
        end
        new_fragments[i*FB+:FB] = fragment;
      end
    end
  end

  // ---- The corner sum, saturated: a change of -1, 0 or 1 ----
  logic signed [R:0]   corner_sum;
  logic signed [R-1:0] new_corner;
  assign corner_sum = (R + 1)'(corner) + signed'((R + 1)'(corner_i)) - 
                      signed'((R + 1)'(dropped_o && contains_i && !mutations_pkg::SLB_KEEP_CORNER));
  always_comb begin
    if (corner_sum[R] == corner_sum[R-1]) new_corner = corner_sum[R-1:0];
    else                                  new_corner = {corner_sum[R], {(R - 1){!corner_sum[R]}}};
  end

  logic [D-1:0]  new_full_depth;
  logic [CB-1:0] new_count;
  assign new_full_depth = (evict && kept_answer && evict_depth < full_depth) ? evict_depth : full_depth;
  assign new_count      = CB'(place) + CB'(append);
  always_comb begin
    entry_o = 'x;
    if (valid_i) begin
      entry_o = {
        new_fragments, new_full_depth, new_corner, open || append, overflow || dropped_o || reduced_o || evict, new_count
      };
    end
  end

  logic unused_group;
  assign unused_group = ^{first, group_depth, chains};

endmodule
