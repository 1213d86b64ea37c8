// SPDX-License-Identifier: Apache-2.0
// Cycles by pass and cause. One of them moves in a cycle, so they are a RAM; a bit each says that it has counted since
// reset. With EN_SNAPSHOT all are read at once, so that they are registers.

module cycle_counters #(
  parameter bit EN_SNAPSHOT = 1'b0
) (
  input  logic        clk_i,
  input  logic        rst_ni,
  input  logic        snapshot_i,
  input  logic [3:0]  pass_i,
  input  logic [2:0]  cause_i,
  input  logic [6:0]  number_i,   // CAUSE_COUNT pass + cause
  output logic [63:0] value_o     // 0 where there is no such counter
);

  localparam int unsigned CELLS     = gnomon_pkg::PASS_COUNT * gnomon_pkg::CAUSE_COUNT;
  localparam int unsigned CELL_BITS = $clog2(CELLS);

  logic [63:0]          cycles_q [CELLS];
  logic [CELLS-1:0]     counted_q;
  logic [CELL_BITS-1:0] cell_now, cell_read;
  logic                 exists;
  assign cell_now  = CELL_BITS'(pass_i) * CELL_BITS'(gnomon_pkg::CAUSE_COUNT) + CELL_BITS'(cause_i);
  assign exists    = number_i < 7'(CELLS);
  assign cell_read = exists ? number_i[CELL_BITS-1:0] : '0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) counted_q <= '0;
    else         counted_q[cell_now] <= 1'b1;
  end
  always_ff @(posedge clk_i) begin
    cycles_q[cell_now] <= (counted_q[cell_now] ? cycles_q[cell_now] : 64'd0) + 64'd1;
  end

  if (EN_SNAPSHOT) begin : gen_kept
    logic [CELLS*64-1:0] kept_q;
    for (genvar i = 0; i < CELLS; i++) begin : gen_cells
      always_ff @(posedge clk_i) begin
        if (!rst_ni)         kept_q[i*64+:64] <= '0;
        else if (snapshot_i) kept_q[i*64+:64] <= counted_q[i] ? cycles_q[i] : 64'd0;
      end
    end
    assign value_o = exists ? kept_q[32'(cell_read)*64+:64] : 64'd0;
  end else begin : gen_moment
    logic unused_snapshot;
    assign unused_snapshot = snapshot_i;
    assign value_o         = exists && counted_q[cell_read] ? cycles_q[cell_read] : 64'd0;
  end

endmodule
