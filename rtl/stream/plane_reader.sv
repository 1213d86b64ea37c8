// SPDX-License-Identifier: Apache-2.0
// READ_PLANE: asks read port 0 for consecutive entries and turns the answers into PLANE_ENTRY results, one a cycle.

`include "assertions.svh"

module plane_reader #(
  parameter int unsigned INDEX_BITS = 18,
  parameter int unsigned TAG_BITS   = 42   // of the shared read port; the index travels in it
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic                            start_i,        // only while not busy
  input  logic [INDEX_BITS-1:0]           first_i,
  input  logic [7:0]                      count_minus1_i,
  output logic                            busy_o,
  output logic                            last_o,         // the last result is taken in this cycle
  output logic                            read_valid_o,
  input  logic                            read_ready_i,
  output logic [INDEX_BITS-1:0]           read_index_o,
  output logic [TAG_BITS-1:0]             read_tag_o,
  input  logic                            entry_valid_i,
  output logic                            entry_ready_o,
  input  gnomon_pkg::plane_entry_t        entry_i,
  input  logic [TAG_BITS-1:0]             entry_tag_i,
  output logic                            result_valid_o,
  input  logic                            result_ready_i,
  output gnomon_pkg::plane_entry_result_t result_o
);

  logic [8:0]            to_ask_q, to_give_q;
  logic [INDEX_BITS-1:0] index_q;
  logic                  ask, give;

  assign busy_o       = to_give_q != '0;
  assign read_valid_o = to_ask_q != '0;
  assign read_index_o = index_q;
  assign read_tag_o   = TAG_BITS'(index_q);
  assign ask          = read_valid_o && read_ready_i;

  assign result_valid_o = entry_valid_i;
  assign entry_ready_o  = result_ready_i;
  assign give           = result_valid_o && result_ready_i;
  assign last_o         = give && to_give_q == 9'd1;
  always_comb begin
    result_o.code    = gnomon_pkg::RESULT_PLANE_ENTRY;
    result_o.index   = entry_tag_i[gnomon_pkg::INDEX_FIELD_BITS-1:0];
    result_o.present = entry_i.present;
    result_o.zero    = '0;
    result_o.depth   = entry_i.present ? entry_i.depth : '0;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      to_ask_q  <= '0;
      to_give_q <= '0;
    end else if (start_i) begin
      to_ask_q  <= 9'(count_minus1_i) + 9'd1;
      to_give_q <= 9'(count_minus1_i) + 9'd1;
    end else begin
      if (ask)  to_ask_q  <= to_ask_q - 9'd1;
      if (give) to_give_q <= to_give_q - 9'd1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i)  index_q <= first_i;
    else if (ask) index_q <= index_q + 1'b1;
  end

  logic unused_tag;
  assign unused_tag = ^entry_tag_i[TAG_BITS-1:gnomon_pkg::INDEX_FIELD_BITS];

  `GNOMON_ASSERT(a_start_while_free, !(start_i && busy_o))
  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, read_index_o)

endmodule
