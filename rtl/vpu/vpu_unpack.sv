// SPDX-License-Identifier: Apache-2.0
// Fields of a voxel item (docs/command-stream.md, "Voxel item"), registered: the multipliers' input stage.

module vpu_unpack #(
  parameter int unsigned POSITION_BITS = 10,
  parameter int unsigned NORMAL_BITS   = 9
) (
  input  logic                           clk_i,
  input  logic                           en_i,
  input  logic [63:0]                    item_i,
  output logic [POSITION_BITS-1:0]       x_o, y_o, z_o,
  output logic signed [NORMAL_BITS-1:0]  nx_o, ny_o, nz_o
);

  localparam int unsigned P = POSITION_BITS;
  localparam int unsigned N = NORMAL_BITS;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      x_o  <= item_i[0+:P];
      y_o  <= item_i[P+:P];
      z_o  <= item_i[2*P+:P];
      nx_o <= item_i[3*P+:N];
      ny_o <= item_i[3*P+N+:N];
      nz_o <= item_i[3*P+2*N+:N];
    end
  end

  logic unused_item;
  assign unused_item = ^item_i[63:3*(P+N)];  // ignored by definition; at least bit 63

endmodule
