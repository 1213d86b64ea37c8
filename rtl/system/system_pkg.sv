// SPDX-License-Identifier: Apache-2.0
// What the parts around the core share: who is who on the bus, its channels, rings, faults (docs/system.md).

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package system_pkg;

  // ---- Transactions: an id is {epoch, whether a line of the cache, its number there or the user} ----
  localparam int unsigned USER          = 6;     // widest bits of an id but for the epoch: cache_pkg::LINE_ID + 1
  localparam logic [5:0]  ID_RESULT     = 6'd0;
  localparam logic [5:0]  ID_DESCRIPTOR = 6'd1;  // and completions
  localparam logic [5:0]  ID_COMMAND    = 6'd2;

  localparam int unsigned COMMAND_BURST_LOG2  = 6;   // words; bursts do not cross a multiple of it
  localparam int unsigned COMMAND_BURSTS      = 8;
  localparam int unsigned RESULT_BURSTS_LOG2  = 5;
  localparam int unsigned PATIENCE            = 64;  // grants of others

  // ---- AXI4-Lite: from software, and to it ----
  typedef struct packed {
    logic        awvalid;
    logic [11:0] awaddr;
    logic        wvalid;
    logic [31:0] wdata;
    logic [3:0]  wstrb;
    logic        bready;
    logic        arvalid;
    logic [11:0] araddr;
    logic        rready;
  } axil_want_t;
  typedef struct packed {
    logic        awready;
    logic        wready;
    logic        bvalid;
    logic [1:0]  bresp;
    logic        arready;
    logic        rvalid;
    logic [31:0] rdata;
    logic [1:0]  rresp;
  } axil_give_t;

  // ---- AXI4: channels but for their data, which are as wide as the bus ----
  typedef struct packed {
    logic          valid;
    logic [USER:0] id;
    logic [63:0]   addr;
    logic [7:0]    len;
    logic [2:0]    size;
    logic [1:0]    burst;
  } axi_address_t;  // AR, AW
  typedef struct packed {
    logic          valid;
    logic [USER:0] id;
    logic [1:0]    resp;
  } axi_answer_t;   // R, B
  localparam logic [1:0] INCR = 2'b01;

  // ---- What users want of the master. Active: something is asked for or under way; oldest: the address of the oldest ----
  typedef struct packed {
    logic         read_valid;   // the descriptor at a place, 16 bytes
    logic         read_active;
    logic         write_valid;  // its completion, there too
    logic         write_active;
    logic [63:4]  place;
    logic [127:0] completion;
  } descriptor_want_t;
  typedef struct packed {
    logic        valid;
    logic        active;
    logic [63:3] address;  // of a burst
    logic [6:0]  words;    // 1..64
    logic [63:0] oldest;
  } command_want_t;
  typedef struct packed {
    logic        valid;
    logic        active;
    logic [63:0] oldest;
    logic [63:6] line;
    logic [2:0]  first;  // word of it
    logic [2:0]  last;
  } result_want_t;  // its data go beside it: as a part of it, shifts of 512 bits would cost simulation 5 %
  // What they get.
  typedef struct packed {
    logic ready;
    logic beat;     // is always taken
  } read_give_t;
  typedef struct packed {
    logic ready;
    logic written;  // the oldest
  } write_give_t;

  // ---- Rings ----
  typedef struct packed {
    logic [63:0] base;
    logic [4:0]  log2;   // places
    logic [31:0] head;
    logic [31:0] tail;
  } ring_t;
  localparam int unsigned DESCRIPTOR_LOG2 = 4;  // bytes
  localparam int unsigned WORD_LOG2       = 3;

  localparam logic [15:0] FLAG_LAST      = 16'h0001;
  localparam logic [15:0] FLAG_INTERRUPT = 16'h0002;
  localparam logic [15:0] FLAG_COMPLETE  = 16'h8000;

  // ---- Faults: what stops the hardware ----
  typedef struct packed {
    logic        valid;
    logic [7:0]  code;
    logic [63:0] address;  // of the transaction, else 0
  } fault_t;
  localparam logic [15:0] NO_JOB = 16'hFFFF;

endpackage
/* verilator lint_on UNUSEDPARAM */
