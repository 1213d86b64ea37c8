// SPDX-License-Identifier: Apache-2.0
// Labelled assertions for simulation and proof. They read clk_i and rst_ni of the module that uses them; synthesis
// (which defines SYNTHESIS) leaves them out.

`ifndef GNOMON_ASSERTIONS_SVH
`define GNOMON_ASSERTIONS_SVH

`ifdef SYNTHESIS
`define GNOMON_ASSERT(label_, condition_)
`define GNOMON_ASSERT_STREAM(label_, valid_, ready_, payload_)
`else
// `condition_` holds at every clock edge outside reset.
`define GNOMON_ASSERT(label_, condition_) \
  always_ff @(posedge clk_i) begin \
    if (rst_ni) label_: assert (condition_); \
  end

// A stream obeys the AXI4-Stream rules: once valid it stays valid with the same payload until it is taken.
`define GNOMON_ASSERT_STREAM(label_, valid_, ready_, payload_) \
  always_ff @(posedge clk_i) begin \
    if (rst_ni && $past(rst_ni) && $past((valid_) && !(ready_))) begin \
      label_``_valid: assert (valid_); \
      label_``_payload: assert ((payload_) == $past(payload_)); \
    end \
  end
`endif

`endif
