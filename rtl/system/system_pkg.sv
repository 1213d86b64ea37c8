// SPDX-License-Identifier: Apache-2.0
// What the parts around the core share: who is who on the bus, rings, faults (docs/system.md).

/* verilator lint_off UNUSEDPARAM */  // a module elaborated by itself uses only some
package system_pkg;

  // ---- Transactions: an id is {epoch, whether a line of the cache, its number there or the user} ----
  localparam logic [1:0] ID_RESULT     = 2'd0;
  localparam logic [1:0] ID_DESCRIPTOR = 2'd1;  // and completions
  localparam logic [1:0] ID_COMMAND    = 2'd2;

  localparam int unsigned COMMAND_BURST_LOG2  = 6;   // words; bursts do not cross a multiple of it
  localparam int unsigned COMMAND_BURSTS      = 8;
  localparam int unsigned RESULT_BURSTS_LOG2  = 5;
  localparam int unsigned PATIENCE            = 64;  // grants of others

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
