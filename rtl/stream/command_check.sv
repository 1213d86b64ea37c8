// SPDX-License-Identifier: Apache-2.0
// Errors of a command header (docs/command-stream.md, "Results"), the first that applies in the order 1, 5, 2, 3, 4, 6.
// Combinational.

module command_check #(
  parameter int unsigned PLANE_LOG2      = 9,
  parameter bit          EN_VPU_OFFSET   = 1'b1,
  parameter bit          EN_PERSPECTIVE  = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY = 1'b0,
  parameter bit          EN_FRAME_BUFFER = 1'b0,
  parameter int unsigned FRAME_LAYERS_LOG2 = 0,
  parameter bit          EN_SLB          = 1'b0,
  parameter int unsigned SLB_PLANE_LOG2  = 8
) (
  input  gnomon_pkg::header_t header_i,
  input  logic                allowed_i,  // by the state of the silhouette-line buffer
  output logic [7:0]          error_o   // ERROR_NONE if the command is good
);

  localparam logic [7:0] KEEP_FLAGS = gnomon_pkg::RESOLVE_KEEP | gnomon_pkg::RESOLVE_QUIET;
  logic       known, absent, bad_register, bad_argument;
  logic [7:0] allowed_flags;

  always_comb begin
    known         = 1'b1;
    allowed_flags = 8'h00;
    case (header_i.op)
      gnomon_pkg::OP_FENCE:          allowed_flags = gnomon_pkg::FENCE_CLEAR_STICKY;
      gnomon_pkg::OP_RESOLVE_VOXELS: allowed_flags = gnomon_pkg::RESOLVE_TWO_SIDED | KEEP_FLAGS;
      gnomon_pkg::OP_RESOLVE_TOPOLOGY: allowed_flags = gnomon_pkg::TOPOLOGY_TWO_SIDED | gnomon_pkg::TOPOLOGY_SORTED | KEEP_FLAGS;
      gnomon_pkg::OP_CLEAR_LISTS, gnomon_pkg::OP_PUT_QUADS, gnomon_pkg::OP_READ_LISTS, gnomon_pkg::OP_CLEAR_FRAME,
      gnomon_pkg::OP_NOP, gnomon_pkg::OP_SET_REGISTERS, gnomon_pkg::OP_CLEAR_PLANE, gnomon_pkg::OP_READ_PLANE,
      gnomon_pkg::OP_PROJECT_VOXELS, gnomon_pkg::OP_SLB_CLEAR, gnomon_pkg::OP_FILL, gnomon_pkg::OP_COVER,
      gnomon_pkg::OP_END_OBJECT, gnomon_pkg::OP_QUERY, gnomon_pkg::OP_READ_ENTRIES: ;
      gnomon_pkg::OP_BEGIN_OBJECT:   allowed_flags = gnomon_pkg::BEGIN_FLAT;
      gnomon_pkg::OP_LOOP:           allowed_flags = gnomon_pkg::LOOP_MORE;
      gnomon_pkg::OP_LOOKUP_FRAME:   allowed_flags = gnomon_pkg::LOOKUP_BRICK;
      default:                       known = 1'b0;
    endcase
  end

  localparam logic [4:0] LAYERS = 5'd1 << FRAME_LAYERS_LOG2;
  logic keeps, keeps_or_quiet, bad_layer;
  assign keeps          = gnomon_pkg::is_resolve_op(header_i.op) && (header_i.flags & gnomon_pkg::RESOLVE_KEEP) != '0;
  assign keeps_or_quiet = gnomon_pkg::is_resolve_op(header_i.op) && (header_i.flags & KEEP_FLAGS) != '0;
  assign bad_layer      = 5'(header_i.arg[31:28]) >= LAYERS;

  // The sum of the numbers: 33 bits, so that it does not wrap.
  logic        sets_registers;
  logic [32:0] register_end;
  assign sets_registers = header_i.op == gnomon_pkg::OP_SET_REGISTERS;
  assign register_end   = 33'(header_i.arg) + 33'(header_i.count);
  assign bad_register   = sets_registers && register_end > 33'(gnomon_pkg::REGISTER_COUNT);

  assign absent = (!EN_PERSPECTIVE && sets_registers && !bad_register &&
                   register_end > 33'(gnomon_pkg::PLAIN_REGISTERS)) ||
                  (!EN_VPU_OFFSET && header_i.op == gnomon_pkg::OP_RESOLVE_VOXELS) ||
                  (!EN_VPU_TOPOLOGY && gnomon_pkg::is_topology_op(header_i.op)) ||
                  (!EN_FRAME_BUFFER && (gnomon_pkg::is_frame_op(header_i.op) || keeps_or_quiet)) ||
                  (!EN_SLB && gnomon_pkg::is_slb_op(header_i.op));

  localparam logic [24:0] LAST_ENTRY     = (25'd1 << (2 * PLANE_LOG2)) - 25'd1;
  localparam logic [24:0] LAST_SLB_ENTRY = (25'd1 << (2 * SLB_PLANE_LOG2)) - 25'd1;
  logic [24:0] last_read;
  logic        has_items;
  assign last_read = 25'(header_i.arg[23:0]) + 25'(header_i.arg[31:24]);
  assign has_items = header_i.count != '0;
  always_comb begin
    case (header_i.op)
      gnomon_pkg::OP_CLEAR_PLANE, gnomon_pkg::OP_FENCE, gnomon_pkg::OP_CLEAR_LISTS, gnomon_pkg::OP_CLEAR_FRAME, gnomon_pkg::OP_SLB_CLEAR,
      gnomon_pkg::OP_BEGIN_OBJECT, gnomon_pkg::OP_FILL, gnomon_pkg::OP_END_OBJECT: bad_argument = has_items;
      gnomon_pkg::OP_PUT_QUADS:                       bad_argument = header_i.count[1:0] != '0;  // whole quads
      gnomon_pkg::OP_READ_PLANE, gnomon_pkg::OP_READ_LISTS:
                                                      bad_argument = has_items || last_read > LAST_ENTRY;
      gnomon_pkg::OP_READ_ENTRIES:                    bad_argument = has_items || last_read > LAST_SLB_ENTRY;
      gnomon_pkg::OP_LOOKUP_FRAME:                    bad_argument = bad_layer;
      default:                                        bad_argument = keeps && bad_layer;
    endcase
  end

  always_comb begin
    if (!known)                                        error_o = gnomon_pkg::ERROR_UNKNOWN_OP;
    else if ((header_i.flags & ~allowed_flags) != '0)  error_o = gnomon_pkg::ERROR_RESERVED_FLAG;
    else if (absent)                                   error_o = gnomon_pkg::ERROR_FEATURE_ABSENT;
    else if (bad_register)                             error_o = gnomon_pkg::ERROR_BAD_REGISTER;
    else if (bad_argument)                             error_o = gnomon_pkg::ERROR_BAD_ARGUMENT;
    else if (!allowed_i)                               error_o = gnomon_pkg::ERROR_BAD_SEQUENCE;
    else                                               error_o = gnomon_pkg::ERROR_NONE;
  end

endmodule
