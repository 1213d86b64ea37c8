// SPDX-License-Identifier: Apache-2.0
// The memories of topology mode behind caches of their own (docs/cache.md): list heads in tiles, nodes and quad records in
// the order of their numbers. Ports as those of the memories on chip.

module topology_caches #(
  parameter int unsigned INDEX_BITS    = 18,
  parameter int unsigned NODES_LOG2    = 20,
  parameter int unsigned QUADS_LOG2    = 18,
  parameter int unsigned HEAD          = 42,
  parameter int unsigned NODE          = 59,
  parameter int unsigned RECORD        = 72,
  parameter int unsigned HEAD_TAG      = 49,
  parameter int unsigned NODE_TAG      = 32,
  parameter int unsigned RECORD_TAG    = 71,
  parameter int unsigned SIZE_LOG2     = 15,  // bytes: half for heads, a quarter for nodes and for records
  parameter int unsigned FIRST_LINE    = 0,
  parameter int unsigned LINE_IDS_LOG2 = 4,
  parameter int unsigned STALL_SEED    = 0
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic                  clear_i,        // all of them; only while idle
  output logic                  clearing_o,
  output logic                  idle_o,
  // Heads: read-modify-write, and reads.
  input  logic                  update_valid_i,
  output logic                  update_ready_o,
  input  logic [INDEX_BITS-1:0] update_index_i,
  input  logic [NODE-1:0]       update_operand_i,
  output logic                  modify_valid_o,
  output logic                  modify_present_o,
  output logic [HEAD-1:0]       modify_head_o,
  output logic [NODE-1:0]       modify_operand_o,
  input  logic [HEAD-1:0]       modify_head_i,
  input  logic                  read_valid_i,
  output logic                  read_ready_o,
  input  logic [INDEX_BITS-1:0] read_index_i,
  input  logic [HEAD_TAG-1:0]   read_tag_i,
  output logic                  head_valid_o,
  input  logic                  head_ready_i,
  output logic                  head_present_o,
  output logic [HEAD-1:0]       head_o,
  output logic [HEAD_TAG-1:0]   head_tag_o,
  // Nodes.
  input  logic                  node_write_i,
  output logic                  node_written_o,
  input  logic [NODES_LOG2-1:0] node_write_index_i,
  input  logic [NODE-1:0]       node_i,
  input  logic                  node_ask_i,
  output logic                  node_asked_o,
  input  logic [NODES_LOG2-1:0] node_index_i,
  input  logic [NODE_TAG-1:0]   node_tag_i,
  output logic                  node_valid_o,
  input  logic                  node_ready_i,
  output logic [NODE-1:0]       node_o,
  output logic [NODE_TAG-1:0]   node_tag_o,
  // Quad records; answers are always taken.
  input  logic                  record_write_i,
  output logic                  record_written_o,
  input  logic [QUADS_LOG2-1:0] record_write_index_i,
  input  logic [RECORD-1:0]     record_i,
  input  logic                  record_ask_i,
  output logic                  record_asked_o,
  input  logic [QUADS_LOG2-1:0] record_index_i,
  input  logic [RECORD_TAG-1:0] record_tag_i,
  output logic                  record_valid_o,
  output logic [RECORD-1:0]     record_o,
  output logic [RECORD_TAG-1:0] record_tag_o,
  // Line port: heads, nodes, records, the heads lowest.
  output logic [3*cache_pkg::WANT-1:0] want_o,
  input  logic [3*cache_pkg::GIVE-1:0] give_i,
  output logic [3*cache_pkg::EVENTS-1:0]        events_o
);

  localparam int unsigned HEAD_PLACE   = cache_pkg::places_log2(HEAD + 1);
  localparam int unsigned NODE_PLACE   = cache_pkg::places_log2(NODE + 1);
  localparam int unsigned RECORD_PLACE = cache_pkg::places_log2(RECORD + 1);
  localparam int unsigned HEAD_LINES   = INDEX_BITS - HEAD_PLACE;
  // The smallest pools have fewer lines than a set; a few more do no harm.
  localparam int unsigned NODE_LINES   = gnomon_pkg::max_of(NODES_LOG2 - NODE_PLACE, 3);
  localparam int unsigned RECORD_LINES = gnomon_pkg::max_of(QUADS_LOG2 - RECORD_PLACE, 3);
  localparam int unsigned FIRST_NODE   = FIRST_LINE + cache_pkg::region_lines(HEAD_LINES);
  localparam int unsigned FIRST_RECORD = FIRST_NODE + cache_pkg::region_lines(NODE_LINES);

  logic               heads_idle, nodes_idle, records_idle, heads_clearing, nodes_clearing, records_clearing;
  cache_pkg::want_t   heads_want, nodes_want, records_want;
  cache_pkg::give_t   heads_give, nodes_give, records_give;
  cache_pkg::events_t heads_events, nodes_events, records_events;
  assign want_o                                 = {records_want, nodes_want, heads_want};
  assign {records_give, nodes_give, heads_give} = give_i;
  assign events_o                               = {records_events, nodes_events, heads_events};
  assign idle_o     = heads_idle && nodes_idle && records_idle;
  assign clearing_o = heads_clearing || nodes_clearing || records_clearing;

  // ---- Heads: bits of u and v in turns, so that a line and a set are tiles ----
  logic [INDEX_BITS-1:0] update_place, read_place;
  localparam int unsigned P = INDEX_BITS / 2;
  for (genvar i = 0; i < P; i++) begin : gen_morton
    assign update_place[2*i]   = update_index_i[i];
    assign update_place[2*i+1] = update_index_i[P+i];
    assign read_place[2*i]     = read_index_i[i];
    assign read_place[2*i+1]   = read_index_i[P+i];
  end
  memory_cache #(
    .LINE_BITS(HEAD_LINES), .PLACE_LOG2(HEAD_PLACE), .ENTRY_BITS(HEAD), .OPERAND_BITS(NODE), .TAG_BITS(HEAD_TAG),
    .SIZE_LOG2(SIZE_LOG2 - 1), .FIRST_LINE(FIRST_LINE), .LINE_IDS_LOG2(LINE_IDS_LOG2), .STALL_SEED(STALL_SEED)
  ) u_heads (
    .clk_i, .rst_ni, .update_valid_i, .update_ready_o, .update_line_i(update_place[INDEX_BITS-1:HEAD_PLACE]),
    .update_place_i(update_place[HEAD_PLACE-1:0]), .update_operand_i, .modify_valid_o, .modify_present_o,
    .modify_entry_o(modify_head_o), .modify_operand_o, .modify_entry_i(modify_head_i), .read_valid_i, .read_ready_o,
    .read_line_i(read_place[INDEX_BITS-1:HEAD_PLACE]), .read_place_i(read_place[HEAD_PLACE-1:0]), .read_tag_i,
    .entry_valid_o(head_valid_o), .entry_ready_i(head_ready_i), .entry_present_o(head_present_o), .entry_o(head_o),
    .entry_tag_o(head_tag_o), .clear_i, .clearing_o(heads_clearing), .idle_o(heads_idle), .want_o(heads_want),
    .give_i(heads_give), .events_o(heads_events)
  );

  // ---- Nodes and records: an update puts its operand there ----
  logic              node_put, node_there, node_here, record_put, record_there, record_here, unused_state;
  logic [NODE-1:0]   node_old, node_new;
  logic [RECORD-1:0] record_old, record_new;
  assign unused_state = ^{node_put, node_there, node_here, node_old, record_put, record_there, record_here, record_old};
  memory_cache #(
    .LINE_BITS(NODE_LINES), .PLACE_LOG2(NODE_PLACE), .ENTRY_BITS(NODE), .OPERAND_BITS(NODE), .TAG_BITS(NODE_TAG),
    .SIZE_LOG2(SIZE_LOG2 - 2), .FIRST_LINE(FIRST_NODE), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .STALL_SEED((STALL_SEED == 0) ? 0 : STALL_SEED ^ 32'h1A53)
  ) u_nodes (
    .clk_i, .rst_ni, .update_valid_i(node_write_i), .update_ready_o(node_written_o),
    .update_line_i(NODE_LINES'(node_write_index_i >> NODE_PLACE)),
    .update_place_i(node_write_index_i[NODE_PLACE-1:0]), .update_operand_i(node_i), .modify_valid_o(node_put),
    .modify_present_o(node_there), .modify_entry_o(node_old), .modify_operand_o(node_new),
    .modify_entry_i(node_new), .read_valid_i(node_ask_i), .read_ready_o(node_asked_o),
    .read_line_i(NODE_LINES'(node_index_i >> NODE_PLACE)), .read_place_i(node_index_i[NODE_PLACE-1:0]),
    .read_tag_i(node_tag_i), .entry_valid_o(node_valid_o), .entry_ready_i(node_ready_i), .entry_present_o(node_here),
    .entry_o(node_o), .entry_tag_o(node_tag_o), .clear_i, .clearing_o(nodes_clearing), .idle_o(nodes_idle),
    .want_o(nodes_want), .give_i(nodes_give), .events_o(nodes_events)
  );
  memory_cache #(
    .LINE_BITS(RECORD_LINES), .PLACE_LOG2(RECORD_PLACE), .ENTRY_BITS(RECORD), .OPERAND_BITS(RECORD),
    .TAG_BITS(RECORD_TAG), .SIZE_LOG2(SIZE_LOG2 - 2), .FIRST_LINE(FIRST_RECORD), .LINE_IDS_LOG2(LINE_IDS_LOG2),
    .STALL_SEED((STALL_SEED == 0) ? 0 : STALL_SEED ^ 32'h3D7A)
  ) u_records (
    .clk_i, .rst_ni, .update_valid_i(record_write_i), .update_ready_o(record_written_o),
    .update_line_i(RECORD_LINES'(record_write_index_i >> RECORD_PLACE)),
    .update_place_i(record_write_index_i[RECORD_PLACE-1:0]), .update_operand_i(record_i),
    .modify_valid_o(record_put), .modify_present_o(record_there), .modify_entry_o(record_old),
    .modify_operand_o(record_new), .modify_entry_i(record_new), .read_valid_i(record_ask_i),
    .read_ready_o(record_asked_o), .read_line_i(RECORD_LINES'(record_index_i >> RECORD_PLACE)),
    .read_place_i(record_index_i[RECORD_PLACE-1:0]), .read_tag_i(record_tag_i), .entry_valid_o(record_valid_o),
    .entry_ready_i(1'b1), .entry_present_o(record_here), .entry_o(record_o), .entry_tag_o(record_tag_o), .clear_i,
    .clearing_o(records_clearing), .idle_o(records_idle), .want_o(records_want), .give_i(records_give),
    .events_o(records_events)
  );

endmodule
