// SPDX-License-Identifier: Apache-2.0
// Entry memory of the silhouette-line buffer, latency-insensitive. Full depths, tags and the flags of FILL lie in banks, one
// for each place in a line of 16 pixels, so that FILL writes a line in a cycle; the fragments lie in a memory of their own.
//
//   line:      {generation, has fragments, covered, rim, full_depth} x 16
//   fragments: {answers at the centre, fragments, corner, open, overflow, count}
//   plain:     {plain, covered} of each line of a span; a plain line has no pixel with lines, and says so here alone

`include "assertions.svh"

module slb_plane #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned INDEX_BITS      = 16,
  parameter int unsigned SLOT_BITS       = 4,    // 2^SLOT_BITS pixels a line
  parameter int unsigned SPAN_BITS       = 2,    // 2^SPAN_BITS lines a span
  parameter int unsigned OPERAND_BITS    = 64,
  parameter int unsigned TAG_BITS        = 64,
  parameter int unsigned READ_LATENCY    = 1,
  // Derived; not to be overridden.
  parameter int unsigned ENTRY = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS),
  parameter int unsigned WORD  = ENTRY + FRAGS_PER_PIXEL + 2,  // {covered, rim, centre, entry}
  parameter int unsigned SLOTS = 1 << SLOT_BITS,
  parameter int unsigned SPAN  = 1 << SPAN_BITS,
  parameter int unsigned SPANS = INDEX_BITS - SLOT_BITS - SPAN_BITS
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  // Update port: of an entry, and with `update_line_i` of others in its line.
  input  logic                        update_valid_i,
  output logic                        update_ready_o,
  input  logic                        update_line_i,
  input  logic [INDEX_BITS-1:0]       update_index_i,
  input  logic [OPERAND_BITS-1:0]     update_operand_i,
  // The unit's modify function, combinational. Of a line: which slots get new flags, which of them are covered, which depth
  // those get at most.
  output logic                        modify_valid_o,
  output logic [WORD-1:0]             modify_word_o,
  output logic [OPERAND_BITS-1:0]     modify_operand_o,
  input  logic                        modify_write_i,
  input  logic [WORD-1:0]             modify_word_i,
  input  logic                        line_write_i,
  input  logic [SLOTS-1:0]            line_slots_i,
  input  logic [SLOTS-1:0]            line_covered_i,
  input  logic [DEPTH_BITS-1:0]       line_depth_i,
  // FILL's word on the lines of a span, beside the updates.
  input  logic [SPAN-1:0]             plain_write_i,
  input  logic [SPANS-1:0]            plain_span_i,
  input  logic [SPAN-1:0]             plain_i,
  input  logic [SPAN-1:0]             plain_covered_i,
  // Read port.
  input  logic                        read_valid_i,
  output logic                        read_ready_o,
  input  logic [INDEX_BITS-1:0]       read_index_i,
  input  logic [TAG_BITS-1:0]         read_tag_i,
  output logic                        entry_valid_o,
  input  logic                        entry_ready_i,
  output logic [ENTRY-1:0]            entry_o,
  output logic [TAG_BITS-1:0]         entry_tag_o,
  // Clear; only while idle. After reset every line is scrubbed, and the neighbours' memories with it.
  input  logic                        clear_i,
  output logic                        scrubbing_o,
  output logic [INDEX_BITS-SLOT_BITS-1:0] scrub_line_o,
  output logic                        idle_o
);

  localparam int unsigned D    = DEPTH_BITS;
  localparam int unsigned K    = FRAGS_PER_PIXEL;
  localparam int unsigned LOW  = slb_pkg::count_bits(K) + 2 + slb_pkg::CORNER_BITS;  // below full_depth
  localparam int unsigned HIGH = ENTRY - LOW - D;                                    // fragments
  localparam int unsigned FRAG = K + HIGH + LOW;
  localparam int unsigned G    = gnomon_pkg::GENERATION_BITS;
  localparam int unsigned LANE = G + 3 + D;
  localparam int unsigned LINE_BITS = INDEX_BITS - SLOT_BITS;

  logic [G-1:0] generation;
  logic         scrub_last;
  plane_clear #(.LINE_ADDRESS_BITS(LINE_BITS)) u_clear (
    .clk_i, .rst_ni, .clear_i, .scrubbing_o, .last_o(scrub_last), .line_o(scrub_line_o), .generation_o(generation)
  );

  // ---- Reads: updates first ----
  logic                  take, read, read_any;
  logic [INDEX_BITS-1:0] read_index, a_index;
  assign update_ready_o = !scrubbing_o;
  assign take           = update_valid_i && update_ready_o;
  assign read_any       = take || read;
  assign a_index        = take ? update_index_i : read_index;

  logic [LINE_BITS-1:0] a_line;
  logic [SLOT_BITS-1:0] a_slot;
  assign {a_line, a_slot} = a_index;

  // ---- Writes: an entry, chosen slots of its line or of another, or a line to scrub ----
  logic                  write, line_write_q;
  logic [INDEX_BITS-1:0] write_index;
  logic [WORD-1:0]       write_word;
  logic [LINE_BITS-1:0]  line_q, b_line;
  logic [SLOTS-1:0]      line_slots_q;
  logic                  write_covered, write_rim;
  logic [D-1:0]          write_full;
  assign {write_covered, write_rim} = write_word[WORD-1-:2];
  assign write_full                 = write_word[LOW+:D];
  always_comb begin
    if (scrubbing_o)       b_line = scrub_line_o;
    else if (line_write_q) b_line = line_q;
    else                   b_line = write_index[INDEX_BITS-1:SLOT_BITS];
  end

  // ---- Banks: who reads, who writes, what ----
  logic             line_update;  // a line is at the end of the update port's stages
  logic [SLOTS-1:0] bank_reads, bank_writes;
  always_comb begin
    bank_reads  = '0;
    bank_writes = '0;
    if (read_any)    bank_reads[a_slot] = 1'b1;
    if (take && update_line_i) bank_reads = '1;
    if (line_write_q) bank_writes = line_slots_q;
    if (write)       bank_writes[write_index[SLOT_BITS-1:0]] = 1'b1;
    if (scrubbing_o) bank_writes = '1;
  end

  // What a line's update makes of a lane. No depth is nearer than all ones: without a flat caster the entry stays as stale
  // as it was.
  function automatic logic [LANE-1:0] filled(logic [LANE-1:0] lane, logic covered, logic [D-1:0] depth, logic [G-1:0] now);
    logic [G-1:0] old;
    logic [D-1:0] full;
    logic         has, unused_covered, unused_rim, fresh, lower;
    {old, has, unused_covered, unused_rim, full} = lane;
    fresh  = old == now;
    lower  = covered && depth < (fresh ? full : {D{1'b1}});
    filled = {lower ? now : old, has && fresh, covered, 1'b0, lower ? depth : full};
  endfunction

  // An array, not one wide vector: a simulation then touches the lanes that move.
  (* mem2reg *) logic [LANE-1:0] lanes [SLOTS];
  for (genvar slot = 0; slot < SLOTS; slot++) begin : gen_banks
    logic [LANE-1:0] read_lane, lane, line_lane_q, new_lane, unused_lane;
    always_comb begin
      new_lane = 'x;
      if (bank_writes[slot]) begin
        if (scrubbing_o)                              new_lane = '0;
        else if (line_write_q && line_slots_q[slot])  new_lane = line_lane_q;
        else                                          new_lane = {generation, 1'b1, write_covered, write_rim, write_full};
      end
    end
    plane_bank #(.ADDRESS_BITS(LINE_BITS), .WIDTH(LANE)) u_bank (
      .clk_i, .a_read_i(bank_reads[slot]), .a_address_i(a_line), .a_word_o(read_lane), .b_read_i(1'b0),
      .b_write_i(bank_writes[slot]), .b_address_i(b_line), .b_word_i(new_lane), .b_word_o(unused_lane)
    );
    delay_line #(.WIDTH(LANE), .CYCLES(READ_LATENCY - 1)) u_delay (.clk_i, .data_i(read_lane), .data_o(lane));
    assign lanes[slot] = lane;
    always_ff @(posedge clk_i) begin
      if (line_update) line_lane_q <= filled(lane, line_covered_i[slot], line_depth_i, generation);
    end
  end

  logic [FRAG-1:0] write_fragments, read_fragments, fragments, unused_fragments;
  always_comb begin
    write_fragments = 'x;
    if (write) write_fragments = {write_word[ENTRY+:K], write_word[LOW+D+:HIGH], write_word[LOW-1:0]};
  end
  plane_bank #(.ADDRESS_BITS(INDEX_BITS), .WIDTH(FRAG)) u_fragments (
    .clk_i,
    .a_read_i   (read_any),
    .a_address_i(a_index),
    .a_word_o   (read_fragments),
    .b_read_i   (1'b0),
    .b_write_i  (write),
    .b_address_i(write_index),
    .b_word_i   (write_fragments),
    .b_word_o   (unused_fragments)
  );
  delay_line #(.WIDTH(FRAG), .CYCLES(READ_LATENCY - 1)) u_fragment_delay (
    .clk_i, .data_i(read_fragments), .data_o(fragments)
  );

  // ---- Plain lines, for updates alone ----
  logic [LINE_BITS-1:0] word_line;
  logic [2*SPAN-1:0]    read_plain, plain;
  logic                 line_plain, line_covered;
  for (genvar i = 0; i < SPAN; i++) begin : gen_plain
    logic [1:0] unused_plain;
    plane_bank #(.ADDRESS_BITS(SPANS), .WIDTH(2)) u_bank (
      .clk_i, .a_read_i(take), .a_address_i(a_line[LINE_BITS-1:SPAN_BITS]), .a_word_o(read_plain[2*i+:2]),
      .b_read_i(1'b0), .b_write_i(plain_write_i[i]), .b_address_i(plain_span_i),
      .b_word_i({plain_i[i], plain_covered_i[i]}), .b_word_o(unused_plain)
    );
  end
  delay_line #(.WIDTH(2 * SPAN), .CYCLES(READ_LATENCY - 1)) u_plain_delay (
    .clk_i, .data_i(read_plain), .data_o(plain)
  );
  delay_line #(.WIDTH(LINE_BITS), .CYCLES(READ_LATENCY)) u_line (
    .clk_i, .data_i(a_line & LINE_BITS'(SPAN - 1)), .data_o(word_line)
  );
  assign {line_plain, line_covered} = plain[2*word_line+:2];

  // ---- The entry that was read READ_LATENCY cycles ago, as every reader sees it: a stale one is empty ----
  logic [SLOT_BITS-1:0] word_slot;
  delay_line #(.WIDTH(SLOT_BITS), .CYCLES(READ_LATENCY)) u_slot (.clk_i, .data_i(a_slot), .data_o(word_slot));

  logic [G-1:0]    lane_generation;
  logic            lane_has, lane_covered, lane_rim, current;
  logic [D-1:0]    lane_full;
  logic [FRAG-1:0] seen;
  logic [WORD-1:0] word;
  logic word_read;  // there is one
  delay_line #(.WIDTH(1), .CYCLES(READ_LATENCY)) u_word_read (.clk_i, .data_i(read_any), .data_o(word_read));
  always_comb begin
    {lane_generation, lane_has, lane_covered, lane_rim, lane_full} = 'x;
    current = 'x;
    seen    = 'x;
    word    = 'x;
    if (word_read) begin
      {lane_generation, lane_has, lane_covered, lane_rim, lane_full} = lanes[word_slot];
      current = lane_generation == generation;
      seen    = (current && lane_has) ? fragments : '0;
      word    = {
        line_plain ? line_covered : lane_covered, lane_rim && !line_plain, seen[LOW+:K+HIGH],
        current ? lane_full : {D{1'b1}}, seen[LOW-1:0]
      };
    end
  end

  // ---- Updates ----
  logic                  update_idle;
  logic [INDEX_BITS-1:0] modify_index;
  plane_update #(
    .INDEX_BITS(INDEX_BITS), .OPERAND_BITS(OPERAND_BITS), .WORD_BITS(WORD), .READ_LATENCY(READ_LATENCY)
  ) u_update (
    .clk_i, .rst_ni, .valid_i(take), .index_i(update_index_i), .operand_i(update_operand_i), .ram_word_i(word),
    .modify_valid_o, .modify_index_o(modify_index), .modify_word_o, .modify_operand_o, .modify_write_i,
    .modify_word_i, .write_o(write), .write_index_o(write_index), .write_word_o(write_word), .idle_o(update_idle)
  );

  // A line goes through the same stages, alone or with an entry of its own, so that one write a cycle is left at their end.
  // Nothing is forwarded to it: its slots and the entries updated in a FILL are not the same.
  assign line_update = modify_valid_o && line_write_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) line_write_q <= 1'b0;
    else         line_write_q <= line_update;
  end
  always_ff @(posedge clk_i) begin
    if (line_update) begin
      line_q       <= modify_index[INDEX_BITS-1:SLOT_BITS];
      line_slots_q <= line_slots_i;
    end
  end

  // ---- Read port ----
  logic read_idle;
  plane_read_port #(
    .INDEX_BITS(INDEX_BITS), .TAG_BITS(TAG_BITS), .ENTRY_BITS(ENTRY), .READ_LATENCY(READ_LATENCY)
  ) u_read (
    .clk_i, .rst_ni, .request_valid_i(read_valid_i), .request_ready_o(read_ready_o), .request_index_i(read_index_i),
    .request_tag_i(read_tag_i), .ram_free_i(!scrubbing_o && !update_valid_i), .ram_read_o(read),
    .ram_index_o(read_index), .ram_entry_i(word[ENTRY-1:0]), .response_valid_o(entry_valid_o),
    .response_ready_i(entry_ready_i), .response_entry_o(entry_o), .response_tag_o(entry_tag_o), .idle_o(read_idle)
  );

  assign idle_o = !scrubbing_o && update_idle && read_idle && !line_write_q;

  logic unused_bits;
  assign unused_bits = ^{scrub_last, modify_index[SLOT_BITS-1:0]};

  `GNOMON_ASSERT(a_one_write, !(scrubbing_o && (write || line_write_q)))
  `GNOMON_ASSERT(a_one_line, !(write && line_write_q) || write_index[INDEX_BITS-1:SLOT_BITS] == line_q)
  `GNOMON_ASSERT(a_line_not_entry, !(write && line_write_q && line_slots_q[write_index[SLOT_BITS-1:0]]))

endmodule
