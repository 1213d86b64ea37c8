// SPDX-License-Identifier: Apache-2.0
// Which commands of the silhouette-line buffer its state allows (docs/slb.md, "Commands"). The state follows the headers
// that were taken: a command in error changes nothing.

module slb_sequence (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  gnomon_pkg::header_t header_i,
  input  logic                take_i,     // the header is taken, and it is good
  output logic                allowed_o   // of the header; every command of other units is
);

  typedef enum logic [1:0] {StIdle, StObject, StLoop, StFilled} state_e;
  state_e state_q;
  logic   has_loops_q;  // the object open now has had a LOOP

  always_comb begin
    case (header_i.op)
      gnomon_pkg::OP_SLB_CLEAR, gnomon_pkg::OP_BEGIN_OBJECT, gnomon_pkg::OP_QUERY,
      gnomon_pkg::OP_READ_ENTRIES:   allowed_o = state_q == StIdle;
      gnomon_pkg::OP_LOOP:           allowed_o = state_q == StObject || state_q == StLoop;
      gnomon_pkg::OP_FILL:           allowed_o = state_q == StObject;
      gnomon_pkg::OP_COVER:          allowed_o = state_q == StFilled;
      gnomon_pkg::OP_END_OBJECT:     allowed_o = state_q == StFilled || (state_q == StObject && !has_loops_q);
      default:                       allowed_o = 1'b1;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q     <= StIdle;
      has_loops_q <= 1'b0;
    end else if (take_i) begin
      case (header_i.op)
        gnomon_pkg::OP_BEGIN_OBJECT: begin
          state_q     <= StObject;
          has_loops_q <= 1'b0;
        end
        gnomon_pkg::OP_LOOP: begin
          state_q     <= ((header_i.flags & gnomon_pkg::LOOP_MORE) != '0) ? StLoop : StObject;
          has_loops_q <= 1'b1;
        end
        gnomon_pkg::OP_FILL:       state_q <= StFilled;
        gnomon_pkg::OP_END_OBJECT: state_q <= StIdle;
        default: ;
      endcase
    end
  end

  logic unused_header;
  assign unused_header = ^{header_i.count, header_i.arg};

endmodule
