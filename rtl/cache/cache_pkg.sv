// SPDX-License-Identifier: Apache-2.0
// Sizes and bundles of signals of the caches (docs/cache.md).

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package cache_pkg;

  localparam int unsigned LINE         = 512;  // bits of a line
  localparam int unsigned BANK         = 32;
  localparam int unsigned BANKS        = LINE / BANK;
  localparam int unsigned QUEUE_LOG2   = 8;    // requests looked up and not yet served
  localparam int unsigned NUMBER       = 27;   // of a line, counted from where planes and lists begin

  // A build has 2^LINE_IDS_LOG2 ids each way. These are the widths with most of them; upper bits that are not used are 0.
  localparam int unsigned LINE_ID   = 5;            // of the line port
  localparam int unsigned FILL_ID   = LINE_ID + 1;  // of lines that are to come
  localparam int unsigned VICTIM_ID = LINE_ID + 2;  // of lines on their way out

  // Memories that may lie behind a cache, in their order in memory and among the counters.
  localparam int unsigned MEMORIES        = 6;
  localparam int unsigned PLANE           = 0;  // of the projection unit
  localparam int unsigned LANES           = 1;  // of the silhouette-line buffer: full depths and flags
  localparam int unsigned FRAGMENTS       = 2;
  localparam int unsigned HEADS           = 3;  // of topology mode
  localparam int unsigned NODES           = 4;
  localparam int unsigned RECORDS         = 5;
  localparam int unsigned EVENTS          = 6;  // of each
  localparam logic [6:0]  COUNTER_NUMBER  = 7'd8;  // of the first counter, in the upper half of the indices

  // The line port: what goes out to memory, and what comes in. Lines that come and answers of writes are always taken.
  typedef struct packed {
    logic               read_valid;
    logic [57:0]        read_line;     // address / 64
    logic [LINE_ID-1:0] read_id;
    logic               write_valid;
    logic [57:0]        write_line;
    logic [LINE_ID-1:0] write_id;
    logic [LINE-1:0]    write_data;
  } port_want_t;
  typedef struct packed {
    logic               read_ready;
    logic               write_ready;
    logic               data_valid;
    logic [LINE_ID-1:0] data_id;
    logic               written_valid;
    logic [LINE_ID-1:0] written_id;
    logic [LINE-1:0]    data;
  } port_give_t;

  // What a cache wants of the line port. The line last, where its words are aligned.
  typedef struct packed {
    logic                 read_valid;
    logic [FILL_ID-1:0]   read_id;
    logic [NUMBER-1:0]    read_line;
    logic                 write_valid;
    logic [VICTIM_ID-1:0] write_id;
    logic [NUMBER-1:0]    write_line;
    logic [LINE-1:0]      write_data;
  } want_t;

  // What the line port gives a cache.
  typedef struct packed {
    logic                 read_ready;
    logic                 write_ready;
    logic                 data_valid;
    logic [FILL_ID-1:0]   data_id;
    logic                 written_valid;
    logic [VICTIM_ID-1:0] written_id;
    logic [LINE-1:0]      data;
  } give_t;

  // Bits of both: Yosys does not know $bits of a type in a package.
  localparam int unsigned WANT = 2 + FILL_ID + VICTIM_ID + 2 * NUMBER + LINE;
  localparam int unsigned WANT_READ  = WANT - 1;                        // where its valid bits are
  localparam int unsigned WANT_WRITE = VICTIM_ID + NUMBER + LINE;
  localparam int unsigned GIVE = 4 + FILL_ID + VICTIM_ID + LINE;

  // Events, each at most one a cycle, in the order of the counters.
  typedef struct packed {
    logic hit;         // a request hit
    logic hit_beside;  // and another beside it
    logic miss;
    logic fill;        // a line was asked for
    logic write_back;  // ... or sent to be written
    logic wait_fill;   // the first of the requests waits for its line
  } events_t;

  // Lines from one memory's first to the next one's, of 2^lines: multiples of 4 KiB.
  function automatic int unsigned region_lines(int unsigned lines);
    region_lines = (lines < 6) ? 64 : 1 << lines;
  endfunction

  // Places a line for entries of so many bits, as a logarithm; none is smaller than two banks.
  function automatic int unsigned places_log2(int unsigned bits);
    places_log2 = (bits <= 64) ? 3 : 9 - $clog2(bits);
  endfunction

  // Entries of the silhouette-line buffer whose fragments, of so many bits each, share a line.
  function automatic int unsigned slb_entries_a_line(int unsigned bits);
    slb_entries_a_line = LINE >> $clog2(bits);
  endfunction

  // Lines of its lanes and fragments together: lanes in lines of 16, or of 8 in a plane of 8 columns.
  function automatic int unsigned slb_region_lines(int unsigned plane_log2, int unsigned bits);
    slb_region_lines = region_lines(2 * plane_log2 - ((plane_log2 < 4) ? plane_log2 : 4)) +
                       region_lines(2 * plane_log2 - $clog2(slb_entries_a_line(bits)));
  endfunction

  // Sets of a cache of 2^size bytes with two ways over 2^lines lines: never as many as lines.
  function automatic int unsigned sets_log2(int unsigned size, int unsigned lines);
    sets_log2 = (size - 7 < lines) ? size - 7 : lines - 1;
  endfunction

endpackage
/* verilator lint_on UNUSEDPARAM */
