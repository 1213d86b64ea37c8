// SPDX-License-Identifier: Apache-2.0
// Generation of the plane's entries and the scrubbing that makes it safe. An entry whose tag is not the current
// generation reads as empty, so a clear is one step of the generation; 0 is never current. Scrubbing 1/255 of the lines at
// each clear sees to it that no tag of 255 clears ago is left when its number comes round again (docs/memory.md).

`include "assertions.svh"

module plane_clear #(
  parameter int unsigned LINE_ADDRESS_BITS = 14
) (
  input  logic                                   clk_i,
  input  logic                                   rst_ni,
  input  logic                                   clear_i,       // start a clear; only while not scrubbing
  output logic                                   scrubbing_o,   // a line is scrubbed in this cycle
  output logic                                   last_o,        // ... and it is the last one
  output logic [LINE_ADDRESS_BITS-1:0]           line_o,
  output logic [gnomon_pkg::GENERATION_BITS-1:0] generation_o
);

  localparam int unsigned LINES       = 1 << LINE_ADDRESS_BITS;
  localparam int unsigned GENERATIONS = (1 << gnomon_pkg::GENERATION_BITS) - 1;
  localparam int unsigned SLICE       = (LINES + GENERATIONS - 1) / GENERATIONS;  // rounded up: 255 slices cover all

  logic [LINE_ADDRESS_BITS:0]             left_q;   // lines still to scrub
  logic [LINE_ADDRESS_BITS-1:0]           line_q;
  logic [gnomon_pkg::GENERATION_BITS-1:0] generation_q;

  assign scrubbing_o  = left_q != '0;
  assign last_o       = left_q == (LINE_ADDRESS_BITS + 1)'(1);
  assign line_o       = line_q;
  assign generation_o = generation_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      left_q       <= (LINE_ADDRESS_BITS + 1)'(LINES);
      line_q       <= '0;
      generation_q <= gnomon_pkg::GENERATION_BITS'(1);
    end else if (clear_i) begin
      left_q       <= (LINE_ADDRESS_BITS + 1)'(SLICE);
      if (!mutations_pkg::KEEP_GENERATION)
        generation_q <= (generation_q == '1) ? gnomon_pkg::GENERATION_BITS'(1) : generation_q + 1'b1;
    end else if (scrubbing_o) begin
      left_q <= left_q - 1'b1;
      line_q <= line_q + 1'b1;
    end
  end

  `GNOMON_ASSERT(a_generation_valid, generation_q != '0)
  `GNOMON_ASSERT(a_clear_when_done, !(clear_i && scrubbing_o))

endmodule
