// SPDX-License-Identifier: Apache-2.0
// READ_ENTRIES: asks the read port for consecutive entries and gives each as a header and its raw words, lowest first.

`include "assertions.svh"

module slb_entry_reader #(
  parameter int unsigned INDEX_BITS = 16,
  parameter int unsigned ENTRY_BITS = 180,
  parameter int unsigned WORDS      = 4,    // a power of two, 2..8
  parameter int unsigned TAG_BITS   = 77    // of the shared read port; the index travels in it
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         start_i,         // only while not busy
  input  logic [INDEX_BITS-1:0]        first_i,
  input  logic [7:0]                   count_minus1_i,
  output logic                         busy_o,
  output logic                         read_valid_o,
  input  logic                         read_ready_i,
  output logic [INDEX_BITS-1:0]        read_index_o,
  output logic [TAG_BITS-1:0]          read_tag_o,
  input  logic                         entry_valid_i,
  output logic                         entry_ready_o,
  input  logic [ENTRY_BITS-1:0]        entry_i,
  input  logic [TAG_BITS-1:0]          entry_tag_i,
  output logic                         result_valid_o,
  input  logic                         result_ready_i,
  output logic [63:0]                  result_o
);

  localparam int unsigned STEP_BITS = $clog2(WORDS + 1);

  logic [8:0]            to_ask_q, to_give_q;
  logic [INDEX_BITS-1:0] index_q;
  logic [STEP_BITS-1:0]  step_q;  // 0: the header; n: word n - 1
  logic                  ask, give, last_word;

  assign busy_o       = to_give_q != '0;
  assign read_valid_o = to_ask_q != '0;
  assign read_index_o = index_q;
  assign read_tag_o   = TAG_BITS'(index_q);
  assign ask          = read_valid_o && read_ready_i;

  // The entry stays at the port until its last word is taken.
  gnomon_pkg::slb_entry_result_t header;
  logic [WORDS*64-1:0]           words;
  always_comb begin
    header       = '0;
    header.code  = gnomon_pkg::RESULT_SLB_ENTRY;
    header.index = gnomon_pkg::INDEX_FIELD_BITS'(entry_tag_i[INDEX_BITS-1:0]);
    header.words = 8'(WORDS);
  end
  assign result_valid_o = busy_o && entry_valid_i;
  assign give           = result_valid_o && result_ready_i;
  assign last_word      = step_q == STEP_BITS'(WORDS);
  assign entry_ready_o  = give && last_word;
  always_comb begin
    result_o = header;
    words    = 'x;
    if (result_valid_o) begin
      words = (WORDS * 64)'({entry_i, gnomon_pkg::GENERATION_BITS'(0)});
      for (int i = 0; i < WORDS; i++) begin
        if (step_q == STEP_BITS'(i + 1)) result_o = words[i*64+:64];
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      to_ask_q  <= '0;
      to_give_q <= '0;
      step_q    <= '0;
    end else if (start_i) begin
      to_ask_q  <= 9'(count_minus1_i) + 9'd1;
      to_give_q <= 9'(count_minus1_i) + 9'd1;
    end else begin
      if (ask)               to_ask_q  <= to_ask_q - 9'd1;
      if (give && last_word) to_give_q <= to_give_q - 9'd1;
      if (give)              step_q    <= last_word ? '0 : step_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i)  index_q <= first_i;
    else if (ask) index_q <= index_q + 1'b1;
  end

  logic unused_tag;
  assign unused_tag = ^entry_tag_i;

  `GNOMON_ASSERT(a_start_while_free, !(start_i && busy_o))
  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
