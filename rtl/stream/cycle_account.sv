// SPDX-License-Identifier: Apache-2.0
// Gives every cycle its pass and its cause (docs/command-stream.md, "Counters"). Combinational.

module cycle_account (
  input  logic       idle_i,            // no command in progress
  input  logic       error_i,           // the command in progress is in error
  input  logic [7:0] op_i,              // of the command in progress
  input  logic       stepped_i,         // took a header or an item, or did one step
  input  logic       output_blocked_i,  // a result was offered and not taken
  input  logic       memory_wait_i,     // neither of both, and it waits for a plane
  input  logic       word_valid_i,
  input  logic       word_awaited_i,    // no word, for it is on its way from memory
  input  logic       result_awaited_i,  // a result was not taken, for earlier ones are on their way to memory
  output logic [3:0] pass_o,
  output logic [2:0] cause_o
);

  always_comb begin
    if (idle_i) begin
      pass_o = gnomon_pkg::PASS_IDLE;
    end else if (error_i) begin
      pass_o = gnomon_pkg::PASS_CONTROL;
    end else begin
      case (op_i)
        gnomon_pkg::OP_CLEAR_PLANE, gnomon_pkg::OP_CLEAR_LISTS,
        gnomon_pkg::OP_CLEAR_FRAME, gnomon_pkg::OP_SLB_CLEAR:     pass_o = gnomon_pkg::PASS_CLEAR;
        gnomon_pkg::OP_READ_PLANE, gnomon_pkg::OP_READ_LISTS,
        gnomon_pkg::OP_READ_ENTRIES, gnomon_pkg::OP_LOOKUP_FRAME: pass_o = gnomon_pkg::PASS_READ;
        gnomon_pkg::OP_PROJECT_VOXELS, gnomon_pkg::OP_PUT_QUADS:  pass_o = gnomon_pkg::PASS_PROJECT;
        gnomon_pkg::OP_RESOLVE_VOXELS,
        gnomon_pkg::OP_RESOLVE_TOPOLOGY:                          pass_o = gnomon_pkg::PASS_RESOLVE;
        gnomon_pkg::OP_BEGIN_OBJECT, gnomon_pkg::OP_LOOP:         pass_o = gnomon_pkg::PASS_DRAW;
        gnomon_pkg::OP_FILL, gnomon_pkg::OP_END_OBJECT:           pass_o = gnomon_pkg::PASS_FILL;
        gnomon_pkg::OP_COVER:                                     pass_o = gnomon_pkg::PASS_COVER;
        gnomon_pkg::OP_QUERY:                                     pass_o = gnomon_pkg::PASS_QUERY;
        default:                                                  pass_o = gnomon_pkg::PASS_CONTROL;
      endcase
    end
  end

  always_comb begin
    if (stepped_i)                        cause_o = gnomon_pkg::CAUSE_BUSY;
    else if (idle_i)                      cause_o = gnomon_pkg::CAUSE_IDLE;
    else if (output_blocked_i)            cause_o = result_awaited_i ? gnomon_pkg::CAUSE_MEMORY_WAIT : gnomon_pkg::CAUSE_OUTPUT_BLOCKED;
    else if (memory_wait_i)               cause_o = gnomon_pkg::CAUSE_MEMORY_WAIT;
    else if (word_valid_i)                cause_o = gnomon_pkg::CAUSE_HAZARD;
    else if (word_awaited_i)              cause_o = gnomon_pkg::CAUSE_MEMORY_WAIT;
    else                                  cause_o = gnomon_pkg::CAUSE_INPUT_STARVED;
  end

endmodule
