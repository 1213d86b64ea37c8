// SPDX-License-Identifier: Apache-2.0
// Topology mode of the projection unit, behind vpu_front: quads into the lists of the plane entries that they meet, then voxels,
// whose beams are tested against the quads of their entry (docs/vpu-topology.md has the definition and the pipeline).

`include "assertions.svh"

module topology #(
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter int unsigned MEM_LATENCY      = 1,
  parameter int unsigned MEM_STALL_SEED   = 0,
  parameter int unsigned CACHE_LOG2       = 0,  // not 0: lists in memory, behind caches (docs/cache.md)
  parameter int unsigned LINE_IDS_LOG2    = 4,
  parameter int unsigned FIRST_LINE       = 0,  // there
  // Derived; not to be overridden.
  parameter int unsigned PLACE     = gnomon_pkg::place_bits(PLANE_LOG2),
  parameter int unsigned CLEARANCE = gnomon_pkg::clearance_bits(EN_PERSPECTIVE, DEPTH_BITS)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // A good command of this unit begins with its header; what its items are goes with each of them into the front end.
  // Another kind of command begins only while the unit is idle.
  input  logic                                       start_i,
  input  logic [63:0]                                header_i,
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_o,
  output logic                                       two_sided_o,
  output logic                                       sorted_o,
  output logic [CLEARANCE-1:0]                       clearance_o,
  // The front end.
  output logic                                       stall_o,          // it must not move: an item waits for room
  input  logic                                       front_idle_i,
  // The place of an item.
  input  logic                                       valid_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_i,
  input  logic                                       behind_i,
  input  logic signed [PLACE-1:0]                    u_fine_i, v_fine_i,
  input  logic [DEPTH_BITS-1:0]                      depth_i,
  input  logic                                       saturated_i,
  // The lifted point of a voxel, its clearance in its depth or beside it.
  input  logic                                       moved_valid_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      moved_kind_i,
  input  logic                                       sorted_i,
  input  logic [DEPTH_BITS-1:0]                      clearance_i,
  input  logic                                       moved_behind_i,
  input  logic                                       outside_cone_i,
  input  logic                                       facing_away_i,
  input  logic signed [PLACE-1:0]                    u_moved_i, v_moved_i,
  input  logic [DEPTH_BITS-1:0]                      depth_moved_i,
  output logic                                       result_valid_o,   // TOPOLOGY_STATE and LIST_HEAD words
  input  logic                                       result_ready_i,
  output logic [63:0]                                result_o,
  output logic                                       idle_o,           // without another word nothing more happens
  output logic                                       step_o,           // one step of a clear, a read, a link or a walk
  output logic                                       wait_o,           // a memory holds something back
  output logic                                       clipped_o,        // event: raises QUAD_OFF_PLANE
  output logic                                       quad_behind_o,    // events of the perspective projection
  output logic                                       quad_straddling_o,
  output logic                                       behind_o,
  output logic                                       outside_cone_o,
  output topology_pkg::topology_events_t             events_o,
  // Line port of the caches: heads, nodes, quad records, the heads lowest.
  output logic [3*cache_pkg::WANT-1:0]      cache_want_o,
  input  logic [3*cache_pkg::GIVE-1:0]      cache_give_i,
  output logic [3*cache_pkg::EVENTS-1:0]             cache_events_o
);

  localparam int unsigned D          = DEPTH_BITS;
  localparam int unsigned INDEX      = 2 * PLANE_LOG2;
  localparam int unsigned HEAD       = topology_pkg::head_bits(D, NODES_LOG2);
  localparam int unsigned NODE       = topology_pkg::node_bits(D, NODES_LOG2, QUADS_LOG2);
  localparam int unsigned RECORD     = topology_pkg::record_bits(SUB_BITS, SPAN_LOG2);
  // A walk's round takes 2 MEM_LATENCY + 8 cycles, or twice a memory's latency; the others wait until an older one is done.
  localparam int unsigned WALKS_LOG2 = (CACHE_LOG2 == 0) ? $clog2(2 * MEM_LATENCY + 48) : 8;
  // A head comes back after MEM_LATENCY + 4 cycles; behind a cache as many are looked up ahead of one that is missed.
  localparam int unsigned ROOM_LOG2  = (CACHE_LOG2 == 0) ? $clog2(MEM_LATENCY + 4) : 6;
  localparam int unsigned HEAD_TAG   = topology_pkg::head_tag_bits(EN_PERSPECTIVE, D, PLANE_LOG2 + SUB_BITS);
  localparam int unsigned NODE_TAG   = 2 * topology_pkg::COUNT_BITS + WALKS_LOG2;
  localparam int unsigned RECORD_TAG = NODE_TAG + 1 + NODES_LOG2 + QUADS_LOG2;

  // ---- The command in progress ----
  gnomon_pkg::header_t header;
  logic                clear_start, read_start, put_q, two_sided_q, sorted_q, unused_header;
  logic [CLEARANCE-1:0] clearance_q;
  assign header        = header_i;
  assign clear_start   = start_i && header.op == gnomon_pkg::OP_CLEAR_LISTS;
  assign read_start    = start_i && header.op == gnomon_pkg::OP_READ_LISTS;
  assign unused_header = ^header.count;
  always_ff @(posedge clk_i) begin
    if (start_i) begin
      put_q       <= header.op == gnomon_pkg::OP_PUT_QUADS;
      two_sided_q <= (header.flags & gnomon_pkg::TOPOLOGY_TWO_SIDED) != '0;
      sorted_q    <= (header.flags & gnomon_pkg::TOPOLOGY_SORTED) != '0;
      clearance_q <= header.arg[CLEARANCE-1:0];
    end
  end
  assign kind_o      = put_q ? gnomon_pkg::ITEM_CORNER : gnomon_pkg::ITEM_BEAM;
  assign two_sided_o = two_sided_q;
  assign sorted_o    = sorted_q;
  assign clearance_o = clearance_q;

  logic corner_valid, corner_ready, ask, asked;
  assign stall_o = (corner_valid && !corner_ready) || (ask && !asked);

  // ---- PUT_QUADS ----
  logic                         put_idle, update_valid, update_ready, modify_valid, modify_present;
  logic [INDEX-1:0]             update_index;
  logic [NODE-1:0]              update_operand, modify_operand, put_node;
  logic [HEAD-1:0]              modify_head, new_head;
  logic                         node_write, node_written, record_write, record_written;
  logic [NODES_LOG2-1:0]        put_node_index;
  logic [QUADS_LOG2-1:0]        put_record_index;
  logic [RECORD-1:0]            put_record;
  // Floor to sub-entries; the place is saturated already.
  localparam int unsigned COORDINATE = PLANE_LOG2 + SUB_BITS + 2;
  logic signed [COORDINATE-1:0] corner_u, corner_v;
  assign corner_u     = u_fine_i[PLACE-1-:COORDINATE];
  assign corner_v     = v_fine_i[PLACE-1-:COORDINATE];
  assign corner_valid = valid_i && kind_i == gnomon_pkg::ITEM_CORNER;
  topology_put #(
    .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2),
    .QUADS_LOG2(QUADS_LOG2), .ROOM_LOG2(ROOM_LOG2)
  ) u_put (
    .clk_i, .rst_ni, .clear_i(clear_start), .corner_valid_i(corner_valid), .corner_ready_o(corner_ready),
    .behind_i, .u_i(corner_u), .v_i(corner_v), .depth_i, .saturated_i, .update_valid_o(update_valid),
    .update_ready_i(update_ready), .update_index_o(update_index), .update_operand_o(update_operand),
    .modify_valid_i(modify_valid), .modify_present_i(modify_present), .modify_head_i(modify_head),
    .modify_operand_i(modify_operand), .modify_head_o(new_head), .node_valid_o(node_write),
    .node_ready_i(node_written), .node_index_o(put_node_index), .node_o(put_node), .record_valid_o(record_write),
    .record_ready_i(record_written), .record_index_o(put_record_index), .record_o(put_record), .idle_o(put_idle),
    .put_o(events_o.quad_put), .clipped_o, .missed_o(events_o.quad_off_plane), .too_large_o(events_o.quad_too_large),
    .saturated_o(events_o.quad_saturated), .behind_o(quad_behind_o), .straddling_o(quad_straddling_o),
    .linked_o(events_o.node_linked), .dropped_o(events_o.node_dropped)
  );

  // ---- RESOLVE_TOPOLOGY ----
  logic                           resolve_idle, resolve_head, resolve_taken, head_present, state_valid;
  logic                           node_ask, node_asked, node_valid, node_taken, record_ask, record_asked, record_valid;
  logic [INDEX-1:0]               ask_index;
  logic [HEAD_TAG-1:0]            ask_tag, head_tag;
  logic [HEAD-1:0]                head;
  logic [NODES_LOG2-1:0]          node_index;
  logic [NODE_TAG-1:0]            node_ask_tag, node_tag;
  logic [NODE-1:0]                node;
  logic [QUADS_LOG2-1:0]          record_index;
  logic [RECORD_TAG-1:0]          record_ask_tag, record_tag;
  logic [RECORD-1:0]              record;
  topology_pkg::topology_result_t state;
  topology_resolve #(
    .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .EN_PERSPECTIVE(EN_PERSPECTIVE), .SUB_BITS(SUB_BITS),
    .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .WALKS_LOG2(WALKS_LOG2)
  ) u_resolve (
    .clk_i, .rst_ni, .valid_i(moved_valid_i && moved_kind_i == gnomon_pkg::ITEM_BEAM), .behind_i(moved_behind_i),
    .outside_cone_i, .facing_away_i, .sorted_i, .clearance_i, .u_moved_i, .v_moved_i, .depth_moved_i,
    .idle_o(resolve_idle),
    .read_valid_o(ask), .read_ready_i(asked), .read_index_o(ask_index), .read_tag_o(ask_tag),
    .head_valid_i(resolve_head), .head_ready_o(resolve_taken), .head_present_i(head_present), .head_i(head),
    .head_tag_i(head_tag), .ask_valid_o(node_ask), .ask_ready_i(node_asked), .ask_index_o(node_index),
    .ask_tag_o(node_ask_tag), .node_valid_i(node_valid), .node_ready_o(node_taken), .node_i(node),
    .node_tag_i(node_tag), .fetch_valid_o(record_ask), .fetch_ready_i(record_asked), .fetch_index_o(record_index),
    .fetch_tag_o(record_ask_tag), .record_valid_i(record_valid), .record_i(record), .record_tag_i(record_tag),
    .result_valid_o(state_valid), .result_ready_i, .result_o(state), .visited_o(events_o.node_visited),
    .tested_o(events_o.quad_tested)
  );

  // ---- READ_LISTS: the heads' read port belongs to it while it lasts ----
  logic                            reader_busy, reader_ask, reader_asked, reader_valid, reader_taken;
  logic                            read_valid, read_ready, head_valid, head_ready;
  logic [INDEX-1:0]                reader_index, read_index;
  logic [HEAD_TAG-1:0]             reader_tag;
  topology_pkg::list_head_result_t list_head;
  topology_reader #(.INDEX_BITS(INDEX), .DEPTH_BITS(D), .TAG_BITS(HEAD_TAG)) u_reader (
    .clk_i, .rst_ni, .start_i(read_start), .first_i(header.arg[INDEX-1:0]), .count_minus1_i(header.arg[31:24]),
    .busy_o(reader_busy), .read_valid_o(reader_ask), .read_ready_i(reader_asked), .read_index_o(reader_index),
    .read_tag_o(reader_tag), .head_valid_i(reader_busy && head_valid), .head_ready_o(reader_taken),
    .present_i(head_present), .linked_i(head[HEAD-2]), .dropped_i(head[HEAD-1]), .near_i(head[NODES_LOG2+:D]),
    .index_i(head_tag[INDEX-1:0]), .result_valid_o(reader_valid), .result_ready_i, .result_o(list_head)
  );
  assign read_valid   = reader_busy ? reader_ask : ask;
  assign read_index   = reader_busy ? reader_index : ask_index;
  assign asked        = !reader_busy && read_ready;
  assign reader_asked = reader_busy && read_ready;
  assign resolve_head = !reader_busy && head_valid;
  assign head_ready   = reader_busy ? reader_taken : resolve_taken;

  // ---- Memories ----
  logic scrubbing, heads_idle, nodes_idle, records_idle;
  if (CACHE_LOG2 == 0) begin : gen_on_chip
    entry_memory #(
      .INDEX_BITS(INDEX), .ENTRY_BITS(HEAD), .OPERAND_BITS(NODE), .TAG_BITS(HEAD_TAG), .READ_LATENCY(MEM_LATENCY),
      .STALL_SEED(MEM_STALL_SEED)
    ) u_heads (
      .clk_i, .rst_ni, .update_valid_i(update_valid), .update_ready_o(update_ready), .update_index_i(update_index),
      .update_operand_i(update_operand), .modify_valid_o(modify_valid), .modify_present_o(modify_present),
      .modify_entry_o(modify_head), .modify_operand_o(modify_operand), .modify_entry_i(new_head),
      .read_valid_i(read_valid), .read_ready_o(read_ready), .read_index_i(read_index),
      .read_tag_i(reader_busy ? reader_tag : ask_tag), .entry_valid_o(head_valid), .entry_ready_i(head_ready),
      .entry_present_o(head_present), .entry_o(head), .entry_tag_o(head_tag), .clear_i(clear_start),
      .scrubbing_o(scrubbing), .idle_o(heads_idle)
    );
    topology_store #(
      .INDEX_BITS(NODES_LOG2), .WORD_BITS(NODE), .TAG_BITS(NODE_TAG), .READ_LATENCY(MEM_LATENCY),
      .STALL_SEED(MEM_STALL_SEED)
    ) u_nodes (
      .clk_i, .rst_ni, .write_valid_i(node_write), .write_ready_o(node_written), .write_index_i(put_node_index),
      .write_word_i(put_node), .read_valid_i(node_ask), .read_ready_o(node_asked), .read_index_i(node_index),
      .read_tag_i(node_ask_tag), .word_valid_o(node_valid), .word_ready_i(node_taken), .word_o(node),
      .word_tag_o(node_tag), .idle_o(nodes_idle)
    );
    topology_store #(
      .INDEX_BITS(QUADS_LOG2), .WORD_BITS(RECORD), .TAG_BITS(RECORD_TAG), .READ_LATENCY(MEM_LATENCY),
      .STALL_SEED((MEM_STALL_SEED == 0) ? 0 : MEM_STALL_SEED ^ 32'h3D7A)
    ) u_records (
      .clk_i, .rst_ni, .write_valid_i(record_write), .write_ready_o(record_written), .write_index_i(put_record_index),
      .write_word_i(put_record), .read_valid_i(record_ask), .read_ready_o(record_asked), .read_index_i(record_index),
      .read_tag_i(record_ask_tag), .word_valid_o(record_valid), .word_ready_i(1'b1), .word_o(record),
      .word_tag_o(record_tag), .idle_o(records_idle)
    );
    logic unused_give;
    assign unused_give    = (^cache_give_i) ^ (FIRST_LINE + LINE_IDS_LOG2 == 0);
    assign cache_want_o   = '0;
    assign cache_events_o = '0;
  end else begin : gen_cached
    topology_caches #(
      .INDEX_BITS(INDEX), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2), .HEAD(HEAD), .NODE(NODE),
      .RECORD(RECORD), .HEAD_TAG(HEAD_TAG), .NODE_TAG(NODE_TAG), .RECORD_TAG(RECORD_TAG), .SIZE_LOG2(CACHE_LOG2),
      .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2), .STALL_SEED(MEM_STALL_SEED)
    ) u_caches (
      .clk_i, .rst_ni, .clear_i(clear_start), .clearing_o(scrubbing), .idle_o(heads_idle),
      .update_valid_i(update_valid), .update_ready_o(update_ready), .update_index_i(update_index),
      .update_operand_i(update_operand), .modify_valid_o(modify_valid), .modify_present_o(modify_present),
      .modify_head_o(modify_head), .modify_operand_o(modify_operand), .modify_head_i(new_head),
      .read_valid_i(read_valid), .read_ready_o(read_ready), .read_index_i(read_index),
      .read_tag_i(reader_busy ? reader_tag : ask_tag), .head_valid_o(head_valid), .head_ready_i(head_ready),
      .head_present_o(head_present), .head_o(head), .head_tag_o(head_tag), .node_write_i(node_write),
      .node_written_o(node_written), .node_write_index_i(put_node_index), .node_i(put_node), .node_ask_i(node_ask),
      .node_asked_o(node_asked), .node_index_i(node_index), .node_tag_i(node_ask_tag), .node_valid_o(node_valid),
      .node_ready_i(node_taken), .node_o(node), .node_tag_o(node_tag), .record_write_i(record_write),
      .record_written_o(record_written), .record_write_index_i(put_record_index), .record_i(put_record),
      .record_ask_i(record_ask), .record_asked_o(record_asked), .record_index_i(record_index),
      .record_tag_i(record_ask_tag), .record_valid_o(record_valid), .record_o(record), .record_tag_o(record_tag),
      .want_o(cache_want_o), .give_i(cache_give_i), .events_o(cache_events_o)
    );
    assign nodes_idle   = 1'b1;
    assign records_idle = 1'b1;
  end

  // ---- Results, events, state ----
  logic state_given;
  assign result_valid_o       = reader_valid || state_valid;
  assign result_o             = reader_valid ? list_head : state;
  assign state_given          = state_valid && result_ready_i;
  assign events_o.resolved    = state_given;
  assign events_o.facing_away = state_given && state.facing_away;
  assign events_o.off_plane   = state_given && state.off_plane;
  assign events_o.uncertain   = state_given && state.uncertain;
  assign events_o.hit         = state_given && state.hit;
  assign events_o.fallback    = state_given && state.fallback && !state.unreached;
  assign events_o.shadow      = state_given && state.state == gnomon_pkg::STATE_SHADOW;
  assign behind_o             = state_given && state.unreached && state.fallback;
  assign outside_cone_o       = state_given && state.unreached && !state.fallback;

  assign idle_o = front_idle_i && put_idle && resolve_idle && !reader_busy && heads_idle && nodes_idle && records_idle;
  assign step_o = scrubbing || (update_valid && update_ready) || events_o.node_visited ||
                  (reader_ask && reader_asked) || (reader_valid && result_ready_i);
  assign wait_o = (read_valid && !read_ready) || (update_valid && !update_ready) || (node_write && !node_written) ||
                  (record_write && !record_written) || (node_ask && !node_asked) || (record_ask && !record_asked);

  logic unused_fraction;
  assign unused_fraction = ^{u_fine_i[PLACE-COORDINATE-1:0], v_fine_i[PLACE-COORDINATE-1:0]};

  `GNOMON_ASSERT(a_one_pass, !(corner_valid && ask))
  `GNOMON_ASSERT(a_one_source, !(reader_valid && state_valid))
  `GNOMON_ASSERT(a_alone, !(clear_start || read_start) || idle_o)
  `GNOMON_ASSERT_STREAM(a_result_stable, result_valid_o, result_ready_i, result_o)

endmodule
