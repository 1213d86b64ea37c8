// SPDX-License-Identifier: Apache-2.0
// Gnomon: command stream in, result stream out (docs/command-stream.md). Holds the command decoder, the voxel projection
// unit with the plane memory, its topology mode, the frame buffer, the silhouette-line buffer and the counters.

`include "assertions.svh"

module gnomon_core #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_VPU_OFFSET    = 1'b1,
  parameter bit          EN_PERSPECTIVE   = 1'b0,   // spots and point lights (docs/vpu.md, "Perspective")
  // Topology mode (docs/vpu-topology.md), with memories of its own.
  parameter bit          EN_VPU_TOPOLOGY  = 1'b0,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  // The cubic frame buffer (docs/frame-buffer.md).
  parameter bit          EN_FRAME_BUFFER  = 1'b0,
  parameter int unsigned FRAME_LAYERS_LOG2 = 0,
  // The silhouette-line buffer (docs/slb.md), with a plane of its own.
  parameter bit          EN_SLB           = 1'b0,
  parameter int unsigned SLB_PLANE_LOG2   = 8,
  parameter int unsigned FRAC_BITS        = 7,
  parameter int unsigned SLOPE_BITS       = 7,
  parameter int unsigned FRAGS_PER_PIXEL  = 2,
  parameter int unsigned SUBPIXEL_BITS    = 10,
  parameter int unsigned QUERY_BITS       = 10,
  parameter int unsigned SLB_ROUNDING     = 0,
  parameter int unsigned SLB_DIVIDERS     = 2,
  parameter int unsigned MEM_LATENCY      = 1,      // cycles of a read of a plane's RAM
  // Other than 0 (12..16): planes and lists lie in memory, behind caches of 2^CACHE_LOG2 bytes a unit (docs/cache.md).
  parameter int unsigned CACHE_LOG2       = 0,
  parameter int unsigned LINE_IDS_LOG2    = 4,      // 2^LINE_IDS_LOG2 of their lines may be under way each way
  parameter bit          EN_BUS           = 1'b0,   // inside gnomon_top: heeds the inputs from around it
  parameter int unsigned MEM_STALL_SEED   = 0       // test aid: other than 0 (1..65535), the planes' ports stall at random
) (
  input  logic        clk_i,
  input  logic        rst_ni,           // synchronous
  // Command words, AXI4-Stream.
  input  logic        cmd_valid_i,
  output logic        cmd_ready_o,
  input  logic [63:0] cmd_data_i,
  // Result words, AXI4-Stream.
  output logic        res_valid_o,
  input  logic        res_ready_i,
  output logic [63:0] res_data_o,
  // Counters, combinational: 0..10 events, 11 sticky flags, 16..38 events of the silhouette-line buffer,
  // 40..54 of topology mode, 55..61 of the perspective projection, 64 + 6 pass + cause cycles, 128..132
  // of the frame buffer, 136.. of the caches.
  input  logic [7:0]  counter_index_i,
  output logic [63:0] counter_value_o,
  // Nothing under way and nothing buffered: without another word nothing more will happen. Also between the items of a
  // command.
  output logic        idle_o,
  // To and from what is around the core (docs/system.md). Without EN_BUS the inputs are ignored, and counters show
  // the moment instead of the last snapshot.
  input  logic        counter_snapshot_i,   // copies all counters
  input  logic        word_awaited_i,       // the next command word is on its way from memory
  input  logic        result_awaited_i,     // results wait for memory
  output logic        in_command_o,         // the next command word is an item
  output logic        error_given_o,        // an error result is given
  output gnomon_pkg::sticky_t raised_o,     // sticky flags raised in this cycle
  // Line port of the caches (docs/cache.md); silent without. Planes and lists lie from `plane_base_i` on, which changes only
  // in reset.
  input  logic [63:12]          plane_base_i,
  output cache_pkg::port_want_t lines_o,
  input  cache_pkg::port_give_t lines_i
);

  parameter_check #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2),
    .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2),
    .QUADS_LOG2(QUADS_LOG2), .EN_FRAME_BUFFER(EN_FRAME_BUFFER), .FRAME_LAYERS_LOG2(FRAME_LAYERS_LOG2),
    .EN_SLB(EN_SLB), .SLB_PLANE_LOG2(SLB_PLANE_LOG2), .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS),
    .FRAGS_PER_PIXEL(FRAGS_PER_PIXEL), .SUBPIXEL_BITS(SUBPIXEL_BITS), .QUERY_BITS(QUERY_BITS),
    .SLB_ROUNDING(SLB_ROUNDING), .SLB_DIVIDERS(SLB_DIVIDERS), .MEM_LATENCY(MEM_LATENCY),
    .MEM_STALL_SEED(MEM_STALL_SEED), .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2)
  ) u_parameter_check ();

  localparam int unsigned INDEX = 2 * PLANE_LOG2;
  localparam int unsigned DEPTH = gnomon_pkg::DEPTH_FIELD_BITS;
  localparam int unsigned TAG0  = gnomon_pkg::own_tag_bits(EN_PERSPECTIVE);
  // 0 is refused above; as a width it would stop elaboration before that message is seen.
  localparam int unsigned LATENCY = (MEM_LATENCY == 0) ? 1 : MEM_LATENCY;

  // ---- Streams at the ports ----
  logic        word_valid, word_ready, result_valid, result_ready;
  logic [63:0] word, result;
  stream_skid #(.WIDTH(64)) u_command_skid (
    .clk_i, .rst_ni, .valid_i(cmd_valid_i), .ready_o(cmd_ready_o), .data_i(cmd_data_i),
    .valid_o(word_valid), .ready_i(word_ready), .data_o(word)
  );
  stream_skid #(.WIDTH(64)) u_result_skid (
    .clk_i, .rst_ni, .valid_i(result_valid), .ready_o(result_ready), .data_i(result),
    .valid_o(res_valid_o), .ready_i(res_ready_i), .data_o(res_data_o)
  );

  // ---- Where memories lie behind caches, each at a multiple of 4 KiB, and their caches' part of the line port ----
  localparam int unsigned WANT     = cache_pkg::WANT;
  localparam int unsigned GIVE     = cache_pkg::GIVE;
  localparam int unsigned SLB_LINE = cache_pkg::region_lines(2 * PLANE_LOG2 - 4);
  localparam int unsigned FRAGMENT_BITS =
    slb_pkg::stored_fragment_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS);
  localparam int unsigned LISTS_LINE =
    SLB_LINE + (EN_SLB ? cache_pkg::slb_region_lines(SLB_PLANE_LOG2, FRAGMENT_BITS) : 0);
  logic [WANT-1:0]                  plane_want;
  logic [GIVE-1:0]                  plane_give;
  logic [cache_pkg::EVENTS-1:0]     plane_events;
  logic [2*WANT-1:0]                slb_want;
  logic [2*GIVE-1:0]                slb_give;
  logic [2*cache_pkg::EVENTS-1:0]   slb_cache_events;
  logic [3*WANT-1:0]                lists_want;
  logic [3*GIVE-1:0]                lists_give;
  logic [3*cache_pkg::EVENTS-1:0]   lists_cache_events;

  // ---- Silhouette-line buffer ----
  logic                    slb_start, slb_item_valid, slb_item_ready, slb_close_valid, slb_close_ready;
  logic                    slb_idle, slb_step, slb_wait, slb_valid;
  logic [63:0]             slb_result;
  gnomon_pkg::slb_events_t slb_events;

  // ---- Voxels and quads ----
  logic                           topology_start, topology_item_valid, topology_item_ready, topology_idle, topology_step;
  logic                           topology_wait, topology_clipped, told_valid;
  logic                           frame_start, frame_item_valid, frame_item_ready, frame_item_last, frame_idle, frame_step;
  logic                           frame_wait, frame_valid;
  logic [63:0]                    told;
  topology_pkg::topology_events_t topology_events;
  frame_pkg::frame_states_t       frame_result;
  frame_pkg::frame_events_t       frame_events;

  // ---- Decoder ----
  logic                                       register_write, item_valid, item_ready, item_resolve;
  logic                                       item_two_sided;
  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index;
  logic                                       vpu_idle, plane_idle, clear_valid, clear_ready, clear_last;
  logic                                       read_start, reading, read_step, read_last;
  logic [INDEX-1:0]                           read_first;
  logic [7:0]                                 read_count_minus1;
  logic                                       decoder_valid;
  logic [63:0]                                decoder_result;
  logic                                       saturated, behind_light, quiet, command, plane_write;
  gnomon_pkg::events_t                        events, voxel_events;
  gnomon_pkg::perspective_events_t            perspective_events;
  gnomon_pkg::sticky_t                        sticky;
  logic [3:0]                                 pass;
  logic [2:0]                                 cause;
  command_decoder #(
    .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(EN_VPU_OFFSET), .EN_PERSPECTIVE(EN_PERSPECTIVE),
    .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY),
    .EN_FRAME_BUFFER(EN_FRAME_BUFFER), .FRAME_LAYERS_LOG2(FRAME_LAYERS_LOG2), .EN_SLB(EN_SLB), .SLB_PLANE_LOG2(SLB_PLANE_LOG2)
  ) u_decoder (
    .clk_i, .rst_ni, .word_valid_i(word_valid), .word_ready_o(word_ready), .word_i(word),
    .register_write_o(register_write), .register_index_o(register_index), .item_valid_o(item_valid),
    .item_ready_i(item_ready), .item_resolve_o(item_resolve), .item_two_sided_o(item_two_sided),
    .vpu_idle_i(vpu_idle), .topology_start_o(topology_start), .topology_item_valid_o(topology_item_valid),
    .topology_item_ready_i(topology_item_ready), .topology_idle_i(topology_idle), .topology_step_i(topology_step),
    .topology_wait_i(topology_wait), .frame_start_o(frame_start), .frame_item_valid_o(frame_item_valid),
    .frame_item_ready_i(frame_item_ready), .frame_item_last_o(frame_item_last), .frame_idle_i(frame_idle),
    .frame_step_i(frame_step), .frame_wait_i(frame_wait), .slb_start_o(slb_start), .slb_item_valid_o(slb_item_valid),
    .slb_item_ready_i(slb_item_ready), .slb_close_valid_o(slb_close_valid), .slb_close_ready_i(slb_close_ready),
    .slb_idle_i(slb_idle), .slb_step_i(slb_step), .slb_wait_i(slb_wait),
    .plane_idle_i(plane_idle), .clear_valid_o(clear_valid), .clear_ready_i(clear_ready),
    .clear_last_i(clear_last), .read_start_o(read_start), .read_first_o(read_first),
    .read_count_minus1_o(read_count_minus1), .reading_o(reading), .read_step_i(read_step), .read_last_i(read_last),
    .result_valid_o(decoder_valid), .result_ready_i(result_ready), .result_o(decoder_result),
    .off_plane_i(voxel_events.project_off_plane), .saturated_i(saturated),
    .list_overflow_i(topology_events.node_dropped), .quad_off_plane_i(topology_clipped), .behind_light_i(behind_light),
    .line_overflow_i(slb_events.chain_dropped || slb_events.chain_reduced),
    .object_overflow_i(slb_events.group_evicted), .winding_saturated_i(slb_events.winding_saturated), .sticky_o(sticky),
    .raised_o,
    .output_blocked_i(result_valid && !result_ready), .word_awaited_i(EN_BUS && word_awaited_i),
    .result_awaited_i(EN_BUS && result_awaited_i), .pass_o(pass), .cause_o(cause),
    .command_o(command), .error_o(error_given_o), .quiet_o(quiet), .in_command_o
  );
  assign idle_o = quiet && !res_valid_o;

  if (EN_SLB) begin : gen_slb
    slb #(
      .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(FRAGS_PER_PIXEL), .DEPTH_BITS(DEPTH_BITS),
      .PLANE_LOG2(SLB_PLANE_LOG2), .SUBPIXEL_BITS(SUBPIXEL_BITS), .QUERY_BITS(QUERY_BITS), .ROUNDING(SLB_ROUNDING),
      .DIVIDERS(SLB_DIVIDERS), .MEM_LATENCY(LATENCY), .MEM_STALL_SEED(MEM_STALL_SEED), .CACHE_LOG2(CACHE_LOG2),
      .LINE_IDS_LOG2(LINE_IDS_LOG2), .FIRST_LINE(SLB_LINE)
    ) u_slb (
      .clk_i, .rst_ni, .start_i(slb_start), .item_valid_i(slb_item_valid), .item_ready_o(slb_item_ready),
      .word_i(word), .close_valid_i(slb_close_valid), .close_ready_o(slb_close_ready), .result_valid_o(slb_valid),
      .result_ready_i(result_ready), .result_o(slb_result), .idle_o(slb_idle), .step_o(slb_step), .wait_o(slb_wait),
      .events_o(slb_events), .cache_want_o(slb_want), .cache_give_i(slb_give), .cache_events_o(slb_cache_events)
    );
  end else begin : gen_no_slb
    assign slb_item_ready  = 1'b1;
    assign slb_close_ready = 1'b1;
    assign slb_valid       = 1'b0;
    assign slb_result      = '0;
    assign slb_idle        = 1'b1;
    assign slb_step        = 1'b0;
    assign slb_wait        = 1'b0;
    assign slb_events      = '0;
    assign slb_want        = '0;
    assign slb_cache_events = '0;
    logic unused_slb;
    assign unused_slb = ^{slb_give, slb_start, slb_item_valid, slb_close_valid};
  end

  // ---- Voxels and quads; what of them goes to the plane ----
  logic                         update_valid, update_ready, modify_write;
  logic [INDEX-1:0]             update_index, read0_index, read1_index;
  logic [DEPTH-1:0]             update_operand, modify_operand, modify_depth;
  gnomon_pkg::plane_entry_t     modify_entry, entry0, entry1;
  logic                         read0_valid, read0_ready, entry0_valid, entry0_ready;
  logic                         read1_valid, read1_ready, entry1_valid, entry1_ready;
  logic [TAG0-1:0]              read0_tag, entry0_tag;
  gnomon_pkg::offset_tag_t      read1_tag, entry1_tag;
  core_voxels #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2), .EN_VPU_OFFSET(EN_VPU_OFFSET),
    .EN_PERSPECTIVE(EN_PERSPECTIVE), .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2),
    .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .EN_FRAME_BUFFER(EN_FRAME_BUFFER),
    .FRAME_LAYERS_LOG2(FRAME_LAYERS_LOG2), .LATENCY(LATENCY), .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .LISTS_LINE(LISTS_LINE), .MEM_STALL_SEED(MEM_STALL_SEED)
  ) u_voxels (
    .clk_i, .rst_ni, .word_i(word), .register_write_i(register_write), .register_index_i(register_index),
    .item_valid_i(item_valid), .item_ready_o(item_ready), .item_resolve_i(item_resolve),
    .item_two_sided_i(item_two_sided), .vpu_idle_o(vpu_idle), .topology_start_i(topology_start),
    .topology_item_valid_i(topology_item_valid), .topology_item_ready_o(topology_item_ready),
    .topology_idle_o(topology_idle), .topology_step_o(topology_step), .topology_wait_o(topology_wait),
    .frame_start_i(frame_start), .frame_item_valid_i(frame_item_valid), .frame_item_last_i(frame_item_last),
    .frame_item_ready_o(frame_item_ready), .frame_idle_o(frame_idle), .frame_step_o(frame_step),
    .frame_wait_o(frame_wait), .update_valid_o(update_valid), .update_ready_i(update_ready),
    .update_index_o(update_index), .update_operand_o(update_operand), .modify_entry_i(modify_entry),
    .modify_operand_i(modify_operand), .modify_write_o(modify_write), .modify_depth_o(modify_depth),
    .read0_valid_o(read0_valid), .read0_ready_i(read0_ready), .read0_index_o(read0_index), .read0_tag_o(read0_tag),
    .entry0_valid_i(entry0_valid), .entry0_ready_o(entry0_ready), .entry0_i(entry0), .entry0_tag_i(entry0_tag),
    .read1_valid_o(read1_valid), .read1_ready_i(read1_ready), .read1_index_o(read1_index), .read1_tag_o(read1_tag),
    .entry1_valid_i(entry1_valid), .entry1_ready_o(entry1_ready), .entry1_i(entry1), .entry1_tag_i(entry1_tag),
    .told_valid_o(told_valid), .told_o(told), .frame_valid_o(frame_valid), .frame_result_o(frame_result),
    .result_ready_i(result_ready), .lists_want_o(lists_want), .lists_give_i(lists_give),
    .lists_events_o(lists_cache_events), .events_o(voxel_events), .perspective_events_o(perspective_events),
    .topology_events_o(topology_events), .frame_events_o(frame_events), .saturated_o(saturated),
    .clipped_o(topology_clipped), .behind_light_o(behind_light)
  );

  // ---- The plane ----
  logic                            reader_valid, reader_busy;
  gnomon_pkg::plane_entry_result_t reader_result;
  core_plane #(
    .PLANE_LOG2(PLANE_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE), .LATENCY(LATENCY), .CACHE_LOG2(CACHE_LOG2),
    .LINE_IDS_LOG2(LINE_IDS_LOG2), .MEM_STALL_SEED(MEM_STALL_SEED)
  ) u_plane (
    .clk_i, .rst_ni, .update_valid_i(update_valid), .update_ready_o(update_ready), .update_index_i(update_index),
    .update_operand_i(update_operand), .modify_entry_o(modify_entry), .modify_operand_o(modify_operand),
    .modify_write_i(modify_write), .modify_depth_i(modify_depth), .wrote_o(plane_write),
    .read0_valid_i(read0_valid), .read0_ready_o(read0_ready), .read0_index_i(read0_index), .read0_tag_i(read0_tag),
    .entry0_valid_o(entry0_valid), .entry0_ready_i(entry0_ready), .entry0_o(entry0), .entry0_tag_o(entry0_tag),
    .read1_valid_i(read1_valid), .read1_ready_o(read1_ready), .read1_index_i(read1_index), .read1_tag_i(read1_tag),
    .entry1_valid_o(entry1_valid), .entry1_ready_i(entry1_ready), .entry1_o(entry1), .entry1_tag_o(entry1_tag),
    .reading_i(reading), .start_i(read_start), .first_i(read_first), .count_minus1_i(read_count_minus1),
    .step_o(read_step), .last_o(read_last), .busy_o(reader_busy), .result_valid_o(reader_valid),
    .result_ready_i(result_ready), .result_o(reader_result), .clear_valid_i(clear_valid), .clear_ready_o(clear_ready),
    .clear_last_o(clear_last), .idle_o(plane_idle), .want_o(plane_want), .give_i(plane_give), .events_o(plane_events)
  );

  // ---- Line port: all caches in turn ----
  core_line_port #(
    .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2), .EN_SLB(EN_SLB), .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY)
  ) u_line_port (
    .clk_i, .rst_ni, .plane_base_i, .plane_want_i(plane_want), .plane_give_o(plane_give), .slb_want_i(slb_want),
    .slb_give_o(slb_give), .lists_want_i(lists_want), .lists_give_o(lists_give), .port_o(lines_o), .port_i(lines_i)
  );

  // ---- Results: a change of kind is a barrier, so that one source speaks at a time and command order is kept ----
  assign result_valid = decoder_valid || reader_valid || frame_valid || slb_valid || told_valid;
  always_comb begin
    if (decoder_valid)     result = decoder_result;
    else if (reader_valid) result = reader_result;
    else if (frame_valid)  result = frame_result;
    else if (slb_valid)    result = slb_result;
    else                   result = told;
  end

  // ---- Counters ----
  localparam bit                                    CACHED = CACHE_LOG2 != 0;
  localparam logic [cache_pkg::MEMORIES-1:0]        CACHES =
    {{3{CACHED && EN_VPU_TOPOLOGY}}, {2{CACHED && EN_SLB}}, CACHED};
  logic [cache_pkg::MEMORIES*cache_pkg::EVENTS-1:0] cache_events;
  assign cache_events = {lists_cache_events, slb_cache_events, plane_events};
  always_comb begin
    events             = voxel_events;
    events.command     = command;
    events.error       = error_given_o;
    events.plane_write = plane_write;
  end
  counters #(.EN_PERSPECTIVE(EN_PERSPECTIVE), .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY),
    .EN_FRAME_BUFFER(EN_FRAME_BUFFER), .EN_SLB(EN_SLB), .CACHES(CACHES), .EN_SNAPSHOT(EN_BUS)
  ) u_counters (
    .clk_i, .rst_ni, .snapshot_i(counter_snapshot_i), .events_i(events),
    .perspective_events_i(perspective_events), .topology_events_i(topology_events),
    .frame_events_i(frame_events), .slb_events_i(slb_events),
    .cache_events_i(cache_events), .sticky_i(sticky), .pass_i(pass), .cause_i(cause), .index_i(counter_index_i), .value_o(counter_value_o)
  );

  `GNOMON_ASSERT(a_one_result_source, 3'(decoder_valid) + 3'(reader_valid) + 3'(frame_valid) + 3'(slb_valid) +
                 3'(told_valid) <= 3'd1)
  `GNOMON_ASSERT(a_reader_alone, !reader_busy || vpu_idle)
  `GNOMON_ASSERT_STREAM(a_result_stable, res_valid_o, res_ready_i, res_data_o)

endmodule
