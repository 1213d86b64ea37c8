// SPDX-License-Identifier: Apache-2.0
// Test aid: holds back a stream in pseudo-random cycles, to show that its two sides assume no latency. The payload goes
// around it. With SEED 0, the default of everything that uses it, it is two wires.

`include "assertions.svh"

module stall_gate #(
  parameter logic [15:0] SEED = 16'd0
) (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic valid_i,
  output logic ready_o,
  output logic valid_o,
  input  logic ready_i
);

  if (SEED == 16'd0) begin : gen_wires
    logic unused_clock;
    assign unused_clock = clk_i ^ rst_ni;
    assign valid_o      = valid_i;
    assign ready_o      = ready_i;
  end else begin : gen_gate
    // Maximal-length shift register x^16 + x^15 + x^13 + x^4 + 1.
    logic [15:0] lfsr_q;
    logic        open_q;  // stays open until an offered word is taken, so that valid is never withdrawn

    assign valid_o = valid_i && open_q;
    assign ready_o = ready_i && open_q;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        lfsr_q <= SEED;
        open_q <= 1'b0;
      end else begin
        lfsr_q <= {lfsr_q[14:0], lfsr_q[15] ^ lfsr_q[14] ^ lfsr_q[12] ^ lfsr_q[3]};
        open_q <= lfsr_q[0] || (valid_o && !ready_i);
      end
    end

    `GNOMON_ASSERT_STREAM(a_output_stable, valid_o, ready_i, 1'b1)
  end

endmodule
