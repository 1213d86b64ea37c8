// SPDX-License-Identifier: Apache-2.0
// Widths of the silhouette-line buffer's records (docs/slb.md, "Records") and the kinds of its updates. F, S, K, D as on the
// page.

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package slb_pkg;

  localparam int unsigned OBJECT_BITS = 8;
  localparam int unsigned RANGE_BITS  = 5;  // of a sample of COVER
  localparam int unsigned CORNER_BITS = 6;
  localparam int unsigned CHANGE_BITS = 8;  // dw and carry
  localparam int unsigned SPAN_LOG2   = 2;  // lines of a span, where a row has as many

  localparam logic [1:0] FRAGMENT_ONE = 2'd0;
  localparam logic [1:0] FRAGMENT_AND = 2'd1;
  localparam logic [1:0] FRAGMENT_OR  = 2'd2;
  localparam logic [1:0] FRAGMENT_TWO = 2'd3;

  // What an update does to an entry, or to the entries of a line.
  localparam logic [1:0] UPDATE_INSERT = 2'd0;  // put a chain into it
  localparam logic [1:0] UPDATE_FINISH = 2'd1;  // FILL, with lines; and those beside it that have none
  localparam logic [1:0] UPDATE_LINE   = 2'd2;  // FILL, a line without lines
  localparam logic [1:0] UPDATE_COVER  = 2'd3;  // a sample of COVER

  function automatic int unsigned line_bits(int unsigned f, int unsigned s);
    line_bits = 4 + f + s;
  endfunction
  // Bits that hold 2 K - 1.
  function automatic int unsigned threshold_bits(int unsigned k);
    threshold_bits = (k <= 1) ? 1 : (k == 2) ? 2 : 3;
  endfunction
  // Bits that hold K.
  function automatic int unsigned count_bits(int unsigned k);
    count_bits = (k <= 1) ? 1 : (k <= 3) ? 2 : 3;
  endfunction
  function automatic int unsigned fragment_bits(int unsigned f, int unsigned s, int unsigned k, int unsigned d);
    fragment_bits = d + 11 + 2 * line_bits(f, s) + threshold_bits(k);
  endfunction
  // Without the generation: {fragments, full_depth, corner, open, overflow, count}.
  function automatic int unsigned entry_bits(int unsigned f, int unsigned s, int unsigned k, int unsigned d);
    entry_bits = count_bits(k) + 2 + CORNER_BITS + d + k * fragment_bits(f, s, k, d);
  endfunction
  // What FILL knows of a line that it reads: {first of its row, first of its span, lines of its span with lines, line}.
  function automatic int unsigned fill_item_bits(int unsigned line_index_bits, int unsigned span_bits);
    fill_item_bits = 2 + (1 << span_bits) + line_index_bits;
  endfunction

  // Of an entry, what lies beside its full depth and flags, and its fragments' answers at the centre.
  function automatic int unsigned stored_fragment_bits(int unsigned f, int unsigned s, int unsigned k, int unsigned d);
    stored_fragment_bits = entry_bits(f, s, k, d) - d + k;
  endfunction
  // 64-bit words of an entry in a dump: with the generation, rounded up to a power of two.
  function automatic int unsigned dump_words(int unsigned f, int unsigned s, int unsigned k, int unsigned d);
    dump_words = 1 << $clog2((gnomon_pkg::GENERATION_BITS + entry_bits(f, s, k, d) + 63) / 64);
  endfunction

endpackage
/* verilator lint_on UNUSEDPARAM */
