// SPDX-License-Identifier: Apache-2.0
// READ_LISTS: asks the heads' read port for consecutive entries and turns the answers into LIST_HEAD results, one
// a cycle.

`include "assertions.svh"

module topology_reader #(
  parameter int unsigned INDEX_BITS = 18,
  parameter int unsigned DEPTH_BITS = 20,
  parameter int unsigned TAG_BITS   = 49   // of the shared read port; the index travels in it
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,
  input  logic                            start_i,         // only while not busy
  input  logic [INDEX_BITS-1:0]           first_i,
  input  logic [7:0]                      count_minus1_i,
  output logic                            busy_o,
  output logic                            read_valid_o,
  input  logic                            read_ready_i,
  output logic [INDEX_BITS-1:0]           read_index_o,
  output logic [TAG_BITS-1:0]             read_tag_o,
  input  logic                            head_valid_i,
  output logic                            head_ready_o,
  input  logic                            present_i, linked_i, dropped_i,
  input  logic [DEPTH_BITS-1:0]           near_i,
  input  logic [INDEX_BITS-1:0]           index_i,         // out of the tag
  output logic                            result_valid_o,
  input  logic                            result_ready_i,
  output topology_pkg::list_head_result_t result_o
);

  logic [8:0]            to_ask_q, to_give_q;
  logic [INDEX_BITS-1:0] index_q;
  logic                  ask, give;

  assign busy_o       = to_give_q != '0;
  assign read_valid_o = to_ask_q != '0;
  assign read_index_o = index_q;
  assign read_tag_o   = TAG_BITS'(index_q);
  assign ask          = read_valid_o && read_ready_i;

  assign result_valid_o = busy_o && head_valid_i;
  assign head_ready_o   = result_ready_i;
  assign give           = result_valid_o && result_ready_i;
  always_comb begin
    result_o.code       = topology_pkg::RESULT_LIST_HEAD;
    result_o.index      = gnomon_pkg::INDEX_FIELD_BITS'(index_i);
    result_o.present    = present_i;
    result_o.linked     = present_i && linked_i;
    result_o.dropped    = present_i && dropped_i;
    result_o.zero       = '0;
    result_o.near_depth = present_i ? gnomon_pkg::DEPTH_FIELD_BITS'(near_i) : '0;
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

  `GNOMON_ASSERT(a_start_while_free, !(start_i && busy_o))
  `GNOMON_ASSERT_STREAM(a_read_stable, read_valid_o, read_ready_i, read_index_o)

endmodule
