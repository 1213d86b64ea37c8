// SPDX-License-Identifier: Apache-2.0
// Takes the command stream apart: checks headers, hands items to the units, waits where the kind changes, answers FENCE
// and commands in error itself. Says of every cycle which pass it belongs to and what became of it.

`include "assertions.svh"

module command_decoder #(
  parameter int unsigned PLANE_LOG2      = 9,
  parameter bit          EN_VPU_OFFSET   = 1'b1,
  parameter bit          EN_PERSPECTIVE  = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY = 1'b0,
  parameter bit          EN_FRAME_BUFFER = 1'b0,
  parameter int unsigned FRAME_LAYERS_LOG2 = 0,
  parameter bit          EN_SLB          = 1'b0,
  parameter int unsigned SLB_PLANE_LOG2  = 8
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // Command words.
  input  logic                                       word_valid_i,
  output logic                                       word_ready_o,
  input  logic [63:0]                                word_i,
  // VPU.
  output logic                                       register_write_o,
  output logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_o,
  output logic                                       item_valid_o,
  input  logic                                       item_ready_i,
  output logic                                       item_resolve_o,
  output logic                                       item_two_sided_o,
  input  logic                                       vpu_idle_i,
  // Topology mode.
  output logic                                       topology_start_o,  // a good command of its own is taken: word_i
  output logic                                       topology_item_valid_o,  // item of that command: word_i
  input  logic                                       topology_item_ready_i,
  input  logic                                       topology_idle_i,
  input  logic                                       topology_step_i,   // it did one step
  input  logic                                       topology_wait_i,   // it waits for its memories
  // Frame buffer.
  output logic                                       frame_start_o,      // a good command of its own, or a resolve command
  output logic                                       frame_item_valid_o, // item of LOOKUP_FRAME: word_i
  input  logic                                       frame_item_ready_i,
  output logic                                       frame_item_last_o,  // of its command
  input  logic                                       frame_idle_i,
  input  logic                                       frame_step_i,     // it did one step
  input  logic                                       frame_wait_i,     // it waits for its memory
  // Silhouette-line buffer.
  output logic                                       slb_start_o,      // a good command of its own is taken: word_i
  output logic                                       slb_item_valid_o, // item of that command: word_i
  input  logic                                       slb_item_ready_i,
  output logic                                       slb_close_valid_o, // LOOP without MORE: after its last item
  input  logic                                       slb_close_ready_i,
  input  logic                                       slb_idle_i,
  input  logic                                       slb_step_i,       // it did one step
  input  logic                                       slb_wait_i,       // it waits for its memory
  // Plane: fence, clear, read.
  input  logic                                       plane_idle_i,
  output logic                                       clear_valid_o,
  input  logic                                       clear_ready_i,
  input  logic                                       clear_last_i,
  output logic                                       read_start_o,
  output logic [2*PLANE_LOG2-1:0]                    read_first_o,
  output logic [7:0]                                 read_count_minus1_o,
  output logic                                       reading_o,       // READ_PLANE owns read port 0
  input  logic                                       read_step_i,     // it asked or answered in this cycle
  input  logic                                       read_last_i,
  // Results of FENCE and of commands in error.
  output logic                                       result_valid_o,
  input  logic                                       result_ready_i,
  output logic [63:0]                                result_o,
  // Events that raise sticky flags.
  input  logic                                       off_plane_i,
  input  logic                                       saturated_i,
  input  logic                                       list_overflow_i,
  input  logic                                       quad_off_plane_i,
  input  logic                                       behind_light_i,
  input  logic                                       line_overflow_i,
  input  logic                                       object_overflow_i,
  input  logic                                       winding_saturated_i,
  output gnomon_pkg::sticky_t                        sticky_o,
  output gnomon_pkg::sticky_t                        raised_o,          // flags raised in this cycle, set before or not
  // Accounting.
  input  logic                                       output_blocked_i,  // a result was offered and not taken
  input  logic                                       word_awaited_i,    // the next word is on its way from memory
  input  logic                                       result_awaited_i,  // results wait for memory
  output logic [3:0]                                 pass_o,
  output logic [2:0]                                 cause_o,
  output logic                                       command_o,         // event: header taken
  output logic                                       error_o,           // event: error result given
  output logic                                       quiet_o,           // nothing happens before another word comes
  output logic                                       in_command_o       // the next word is an item
);

  typedef enum logic [3:0] {
    StHeader, StItems, StSkip, StResult, StClear, StScrub, StRead,
    StClose,  // the end of a loop is handed over
    StUnit    // topology mode, the frame buffer or the silhouette-line buffer clears, fills or reads
  } state_e;

  state_e              state_q, state_d;
  gnomon_pkg::header_t header, command_q;  // the word as a header; the command in progress, its arg counted up by items
  logic [7:0]          error, error_q;
  logic [31:0]         command_index_q, next_index_q;
  gnomon_pkg::sticky_t sticky_q;

  assign header = word_i;

  logic allowed, good, take_header;
  command_check #(
    .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(EN_VPU_OFFSET), .EN_PERSPECTIVE(EN_PERSPECTIVE), .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY),
    .EN_FRAME_BUFFER(EN_FRAME_BUFFER), .FRAME_LAYERS_LOG2(FRAME_LAYERS_LOG2), .EN_SLB(EN_SLB),
    .SLB_PLANE_LOG2(SLB_PLANE_LOG2)
  ) u_check (.header_i(header), .allowed_i(allowed), .error_o(error));
  assign good = error == gnomon_pkg::ERROR_NONE;
  slb_sequence u_sequence (.clk_i, .rst_ni, .header_i(header), .take_i(take_header && good), .allowed_o(allowed));

  // ---- Headers: a barrier unless the same pass goes on ----
  logic units_idle, drained, streams, same_pass;
  assign units_idle  = topology_idle_i && frame_idle_i && slb_idle_i;
  assign drained     = vpu_idle_i && plane_idle_i && units_idle;
  assign streams     = header.op == gnomon_pkg::OP_PROJECT_VOXELS || header.op == gnomon_pkg::OP_RESOLVE_VOXELS ||
                       header.op == gnomon_pkg::OP_PUT_QUADS || header.op == gnomon_pkg::OP_RESOLVE_TOPOLOGY ||
                       header.op == gnomon_pkg::OP_LOOP || header.op == gnomon_pkg::OP_COVER ||
                       header.op == gnomon_pkg::OP_QUERY || header.op == gnomon_pkg::OP_LOOKUP_FRAME;
  assign same_pass   = good && streams && header.op == command_q.op;
  assign take_header = state_q == StHeader && word_valid_i && (drained || same_pass || mutations_pkg::SKIP_BARRIER);

  // ---- Items ----
  logic to_vpu, to_topology, to_registers, to_frame, to_slb, item_free, take_item, last_item;
  assign to_registers = state_q == StItems && command_q.op == gnomon_pkg::OP_SET_REGISTERS;
  assign to_slb       = state_q == StItems && gnomon_pkg::is_slb_op(command_q.op);
  assign to_topology  = state_q == StItems && gnomon_pkg::is_topology_op(command_q.op);
  assign to_frame     = state_q == StItems && gnomon_pkg::is_frame_op(command_q.op);
  assign to_vpu       = state_q == StItems && !to_registers && !to_slb && !to_topology && !to_frame;
  assign item_free    = state_q == StSkip || to_registers || (to_vpu && item_ready_i) ||
                        (to_topology && topology_item_ready_i) || (to_frame && frame_item_ready_i) ||
                        (to_slb && slb_item_ready_i);
  assign take_item    = word_valid_i && item_free;
  assign last_item    = take_item && command_q.count == 16'd1;
  assign word_ready_o = take_header || take_item;

  assign item_valid_o     = to_vpu && word_valid_i;
  assign item_resolve_o   = command_q.op == gnomon_pkg::OP_RESOLVE_VOXELS;
  assign item_two_sided_o = (command_q.flags & gnomon_pkg::RESOLVE_TWO_SIDED) != '0;
  assign register_write_o = to_registers && word_valid_i;
  assign register_index_o = command_q.arg[gnomon_pkg::REGISTER_INDEX_BITS-1:0];

  assign topology_start_o      = take_header && good && gnomon_pkg::is_topology_op(header.op);
  assign topology_item_valid_o = to_topology && word_valid_i;

  assign frame_start_o      = take_header && good &&
                              (gnomon_pkg::is_frame_op(header.op) || gnomon_pkg::is_resolve_op(header.op));
  assign frame_item_valid_o = to_frame && word_valid_i;
  assign frame_item_last_o  = command_q.count == 16'd1;

  assign slb_start_o       = take_header && good && gnomon_pkg::is_slb_op(header.op);
  assign slb_item_valid_o  = to_slb && word_valid_i;
  assign slb_close_valid_o = state_q == StClose;

  // ---- Results of its own ----
  logic                        is_error, give;
  gnomon_pkg::fence_result_t   fence_result;
  gnomon_pkg::error_result_t   error_result;
  assign is_error       = error_q != gnomon_pkg::ERROR_NONE;
  assign result_valid_o = state_q == StResult;
  assign give           = result_valid_o && result_ready_i;
  always_comb begin
    fence_result.code          = gnomon_pkg::RESULT_FENCE;
    fence_result.zero          = '0;
    fence_result.sticky        = sticky_q;
    fence_result.tag           = command_q.arg;
    error_result.code          = gnomon_pkg::RESULT_ERROR;
    error_result.error         = error_q;
    error_result.zero          = '0;
    error_result.command_index = command_index_q;
  end
  assign result_o = is_error ? error_result : fence_result;

  // ---- Plane ----
  assign clear_valid_o       = state_q == StClear;
  assign reading_o           = state_q == StRead;
  assign read_start_o        = take_header && good && header.op == gnomon_pkg::OP_READ_PLANE;
  assign read_first_o        = header.arg[2*PLANE_LOG2-1:0];
  assign read_count_minus1_o = header.arg[31:24];

  // ---- State ----
  // What follows the last item of the command in progress, or of the header with none.
  logic closes_header, closes_command;
  assign closes_header  = header.op == gnomon_pkg::OP_LOOP && (header.flags & gnomon_pkg::LOOP_MORE) == '0;
  assign closes_command = state_q == StItems && command_q.op == gnomon_pkg::OP_LOOP &&
                          (command_q.flags & gnomon_pkg::LOOP_MORE) == '0;
  always_comb begin
    state_d = state_q;
    case (state_q)
      StHeader: begin
        if (take_header) begin
          if (!good) begin
            state_d = StResult;
          end else begin
            case (header.op)
              gnomon_pkg::OP_CLEAR_PLANE: state_d = StClear;
              gnomon_pkg::OP_FENCE:       state_d = StResult;
              gnomon_pkg::OP_READ_PLANE:  state_d = StRead;
              gnomon_pkg::OP_CLEAR_LISTS, gnomon_pkg::OP_READ_LISTS, gnomon_pkg::OP_CLEAR_FRAME,
              gnomon_pkg::OP_SLB_CLEAR, gnomon_pkg::OP_FILL, gnomon_pkg::OP_READ_ENTRIES: state_d = StUnit;
              gnomon_pkg::OP_NOP:         state_d = (header.count == '0) ? StHeader : StSkip;
              default: begin
                if (header.count != '0) state_d = StItems;
                else if (closes_header) state_d = StClose;
              end
            endcase
          end
        end
      end
      StItems, StSkip: if (last_item) state_d = closes_command ? StClose : StHeader;
      StClose:         if (slb_close_ready_i) state_d = StHeader;
      StUnit:          if (units_idle) state_d = StHeader;
      StResult:        if (give) state_d = (is_error && command_q.count != '0) ? StSkip : StHeader;
      StClear:         if (clear_ready_i) state_d = StScrub;
      StScrub:         if ((clear_last_i || plane_idle_i) && units_idle) state_d = StHeader;
      StRead:          if (read_last_i) state_d = StHeader;
      default:         state_d = StHeader;
    endcase
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q         <= StScrub;  // the planes scrub themselves after reset
      command_q       <= '0;
      command_q.op    <= gnomon_pkg::OP_CLEAR_PLANE;
      error_q         <= gnomon_pkg::ERROR_NONE;
      command_index_q <= '0;
      next_index_q    <= '0;
    end else begin
      state_q <= state_d;
      if (take_header) begin
        command_q       <= header;
        error_q         <= error;
        command_index_q <= next_index_q;
        next_index_q    <= next_index_q + 32'd1;
      end else if (take_item) begin
        command_q.count <= command_q.count - 16'd1;
        command_q.arg   <= command_q.arg + 32'd1;
      end
    end
  end

  // ---- Sticky flags: a FENCE reports what it clears; nothing raises one in that cycle, the units are drained ----
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sticky_q <= '0;
    end else if (give && !is_error && (command_q.flags & gnomon_pkg::FENCE_CLEAR_STICKY) != '0) begin
      sticky_q <= '0;
    end else begin
      sticky_q <= sticky_q | raised_o;
    end
  end
  always_comb begin
    raised_o                   = '0;
    raised_o.error_seen        = error_o;
    raised_o.off_plane         = off_plane_i && !mutations_pkg::LOSE_STICKY;
    raised_o.depth_saturated   = saturated_i;
    raised_o.list_overflow     = list_overflow_i;
    raised_o.quad_off_plane    = quad_off_plane_i;
    raised_o.behind_light      = behind_light_i;
    raised_o.line_overflow     = line_overflow_i;
    raised_o.object_overflow   = object_overflow_i;
    raised_o.winding_saturated = winding_saturated_i;
  end
  assign sticky_o  = sticky_q;
  assign command_o = take_header;
  assign error_o   = give && is_error;
  assign in_command_o = state_q == StItems || state_q == StSkip;
  assign quiet_o   = !word_valid_i && drained && (state_q == StHeader || state_q == StItems || state_q == StSkip);

  // ---- Accounting ----
  logic stepped, starved, unit_step, unit_wait;
  assign unit_step = topology_step_i || frame_step_i || slb_step_i;
  assign unit_wait = topology_wait_i || frame_wait_i || slb_wait_i;
  always_comb begin
    case (state_q)
      StHeader:        stepped = take_header || unit_step;
      StItems, StSkip: stepped = take_item || unit_step;
      StResult:        stepped = give;
      StClear:         stepped = clear_ready_i;
      StScrub:         stepped = 1'b1;
      StClose:         stepped = slb_close_ready_i || slb_step_i;
      StUnit:          stepped = unit_step;
      default:         stepped = read_step_i;
    endcase
  end
  // Where another word would have been taken: the pipelines are not held up. Topology mode and the silhouette-line buffer
  // say themselves what they wait for.
  always_comb begin
    if ((gnomon_pkg::is_slb_op(command_q.op) || gnomon_pkg::is_topology_op(command_q.op) ||
         gnomon_pkg::is_frame_op(command_q.op)) && state_q != StUnit)
      starved = !unit_wait;
    else starved = item_free || (state_q == StHeader && item_ready_i);
  end
  cycle_account u_account (
    .idle_i(state_q == StHeader && !take_header && drained), .error_i(take_header ? !good : is_error),
    .op_i(take_header ? header.op : command_q.op), .stepped_i(stepped), .output_blocked_i,
    .memory_wait_i(!starved), .word_valid_i, .word_awaited_i, .result_awaited_i, .pass_o, .cause_o
  );

  `GNOMON_ASSERT_STREAM(a_item_stable, item_valid_o, item_ready_i, {word_i, item_resolve_o, item_two_sided_o})
  `GNOMON_ASSERT_STREAM(a_topology_item_stable, topology_item_valid_o, topology_item_ready_i, word_i)
  `GNOMON_ASSERT_STREAM(a_frame_item_stable, frame_item_valid_o, frame_item_ready_i, {word_i, frame_item_last_o})
  `GNOMON_ASSERT_STREAM(a_slb_item_stable, slb_item_valid_o, slb_item_ready_i, word_i)
  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)
  `GNOMON_ASSERT(a_register_exists, !register_write_o || command_q.arg < 32'(gnomon_pkg::REGISTER_COUNT))

endmodule
