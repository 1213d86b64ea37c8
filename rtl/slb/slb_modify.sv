// SPDX-License-Identifier: Apache-2.0
// The modify function of the entry memory: what each kind of update makes of the word that was read. Combinational.

module slb_modify #(
  parameter int unsigned FRAC_BITS       = 7,
  parameter int unsigned SLOPE_BITS      = 7,
  parameter int unsigned FRAGS_PER_PIXEL = 2,
  parameter int unsigned DEPTH_BITS      = 20,
  parameter int unsigned PLANE_LOG2      = 8,
  parameter int unsigned ROUNDING        = 0,
  // Derived; not to be overridden.
  parameter int unsigned LINE    = slb_pkg::line_bits(FRAC_BITS, SLOPE_BITS),
  parameter int unsigned ENTRY   = slb_pkg::entry_bits(FRAC_BITS, SLOPE_BITS, FRAGS_PER_PIXEL, DEPTH_BITS),
  parameter int unsigned WORD    = ENTRY + FRAGS_PER_PIXEL + 2,
  parameter int unsigned WINDING = PLANE_LOG2 + 9
) (
  // Of the object being drawn.
  input  logic [slb_pkg::OBJECT_BITS-1:0] object_i,
  input  logic                            flat_i,
  input  logic [DEPTH_BITS-1:0]           flat_depth_i,
  // The update.
  input  logic                            valid_i,
  input  logic [1:0]                      kind_i,
  input  logic [WORD-1:0]                 word_i,        // {covered, rim, answers at the centre, entry}
  input  logic [DEPTH_BITS-1:0]           depth_i,       // of the chain, of the sample
  input  logic [1:0]                      op_i,
  input  logic [LINE-1:0]                 a_i,
  input  logic [LINE-1:0]                 b_i,
  input  logic [LINE-1:0]                 join_i,
  input  logic                            contains_i,
  input  logic                            corner_i,
  input  logic signed [WINDING-1:0]       winding_i,
  input  logic [DEPTH_BITS-1:0]           front_i,       // of the sample
  input  logic [DEPTH_BITS-1:0]           margin_i,
  output logic                            write_o,
  output logic [WORD-1:0]                 word_o,
  output logic                            line_write_o,
  output logic [DEPTH_BITS-1:0]           line_depth_o,
  // Events.
  output logic                            dropped_o,
  output logic                            reduced_o,
  output logic                            evicted_o,
  output logic                            filled_group_o,
  output logic                            filled_covered_o,  // a pixel with lines
  output logic                            cover_used_o
);

  localparam int unsigned K = FRAGS_PER_PIXEL;

  // Of the three only the one that the update is for does anything.
  logic insert, finish, line, sample;
  assign insert = valid_i && kind_i == slb_pkg::UPDATE_INSERT;
  assign finish = valid_i && kind_i == slb_pkg::UPDATE_FINISH;
  assign line   = valid_i && kind_i == slb_pkg::UPDATE_LINE;
  assign sample = valid_i && kind_i == slb_pkg::UPDATE_COVER;

  logic             covered, rim;
  logic [K-1:0]     centre;
  logic [ENTRY-1:0] entry;
  assign {covered, rim, centre, entry} = word_i;

  logic [ENTRY-1:0] inserted_entry;
  logic [K-1:0]     inserted_centre;
  logic             dropped, reduced, evicted;
  slb_insert #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(DEPTH_BITS)
  ) u_insert (
    .valid_i(insert), .entry_i(entry), .centre_i(centre), .depth_i, .object_i, .op_i, .a_i, .b_i, .join_i, .contains_i, .corner_i,
    .entry_o(inserted_entry), .centre_o(inserted_centre), .dropped_o(dropped), .reduced_o(reduced),
    .evicted_o(evicted)
  );

  logic [ENTRY-1:0] finished_entry;
  logic [K-1:0]     finished_centre;
  logic             finished_covered, finished_rim;
  slb_finish #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(DEPTH_BITS),
    .WINDING_BITS(WINDING), .ROUNDING(ROUNDING)
  ) u_finish (
    .valid_i(finish), .entry_i(entry), .centre_i(centre), .winding_i, .flat_i, .depth_i(flat_depth_i), .entry_o(finished_entry),
    .centre_o(finished_centre), .covered_o(finished_covered), .rim_o(finished_rim)
  );

  logic [ENTRY-1:0] lowered_entry;
  logic             used;
  slb_cover #(
    .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(K), .DEPTH_BITS(DEPTH_BITS)
  ) u_cover (
    .valid_i(sample), .entry_i(entry), .covered_i(covered), .rim_i(rim), .front_i, .depth_i, .margin_i, .entry_o(lowered_entry),
    .used_o(used)
  );

  always_comb begin
    word_o = 'x;
    if (insert) word_o = {covered, rim, inserted_centre, inserted_entry};
    if (finish) word_o = {finished_covered, finished_rim, finished_centre, finished_entry};
    if (sample) word_o = {covered, rim, centre, lowered_entry};
  end
  assign write_o      = insert || finish || (sample && used);
  assign line_write_o = line || (finish && !mutations_pkg::SLB_ENTRY_ALONE);
  assign line_depth_o = flat_i ? flat_depth_i : '1;

  assign dropped_o        = insert && dropped;
  assign reduced_o        = insert && reduced;
  assign evicted_o        = insert && evicted;
  assign filled_group_o   = finish;
  assign filled_covered_o = finish && finished_covered;
  assign cover_used_o     = sample && used;

endmodule
