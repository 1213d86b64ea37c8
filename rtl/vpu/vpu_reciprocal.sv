// SPDX-License-Identifier: Apache-2.0
// Reciprocal of a normalised number: a seed from a table of 512, one Newton step (docs/vpu.md, "Reciprocal"). Four stages:
// seed, product, difference, product.

module vpu_reciprocal (
  input  logic        clk_i,
  input  logic        en_i,
  input  logic [23:0] m_i,   // 23 fraction bits, the highest bit is 1
  output logic [23:0] r_o    // 24 fraction bits
);

  // floor((2^27 + o) / (2 o)), o = 2^10 + 2 i + 1: 2^16 over the middle of interval i, rounded to nearest.
  logic [15:0] seeds [512];
  integer i;
  initial begin
    for (i = 0; i < 512; i = i + 1) seeds[i] = 16'((134217728 + 1025 + 2 * i) / (2050 + 4 * i));
  end

  logic [15:0] seed1_q, seed2_q, seed3_q;
  logic [23:0] m1_q;
  logic [39:0] product2_q;
  logic [40:0] rest;
  logic [24:0] t3_q;
  logic [40:0] product4;
  assign rest     = 41'h100_0000_0000 - 41'(product2_q);  // 2^40 - m·seed: positive, below 2^40
  assign product4 = 41'(seed3_q) * 41'(t3_q);
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      seed1_q    <= seeds[m_i[22:14]];
      m1_q       <= m_i;
      product2_q <= 40'(m1_q) * 40'(seed1_q);
      seed2_q    <= seed1_q;
      t3_q       <= rest[39:15];      // floor
      seed3_q    <= seed2_q;
      r_o        <= mutations_pkg::PERSPECTIVE_NO_STEP ? {seed3_q, 8'd0} : product4[39:16];  // floor; below 2^24
    end
  end

  logic unused_bits;
  assign unused_bits = ^{rest[40], rest[14:0], product4[40], product4[15:0]};

endmodule
