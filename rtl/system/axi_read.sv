// SPDX-License-Identifier: Apache-2.0
// Read channels of the AXI master: grants users, sends addresses, hands out answers by id. Answers are always taken; those
// of an earlier epoch are swallowed (docs/system.md, "The master").

`include "assertions.svh"

module axi_read #(
  parameter int unsigned AXI_DATA_BITS = 64,
  parameter bit          EN_LINES      = 1'b0,  // the cache's line port is used
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                          clk_i,
  input  logic                          rst_ni,
  input  logic                          core_rst_ni,   // of the users
  input  logic                          may_start_i,
  input  logic                          epoch_i,
  input  logic                          give_up_i,
  output logic                          pending_o,     // of this epoch
  output logic                          late_o,        // answers of the epoch before are due
  // Users.
  input  system_pkg::descriptor_want_t  descriptor_i,  // its reads
  output system_pkg::read_give_t        descriptor_o,
  input  system_pkg::command_want_t     command_i,
  output system_pkg::read_give_t        command_o,
  output logic [AXI_DATA_BITS-1:0]      beat_o,        // of both
  output logic                          beat_last_o,
  // Lines.
  input  cache_pkg::port_want_t         lines_i,       // its reads
  output logic                          line_read_ready_o,
  output logic                          line_data_valid_o,
  output logic [cache_pkg::LINE_ID-1:0] line_data_id_o,
  output logic [511:0]                  line_data_o,
  // AXI.
  output system_pkg::axi_address_t      ar_o,
  input  logic                          arready_i,
  input  system_pkg::axi_answer_t       r_i,
  input  logic                          rlast_i,
  input  logic [AXI_DATA_BITS-1:0]      rdata_i,
  // Where a transaction waits, for a timeout; faults.
  output logic                          active_o,
  output logic [63:0]                   active_address_o,
  output system_pkg::fault_t            fault_o
);

  localparam int unsigned USER       = system_pkg::USER;
  localparam int unsigned LANES_LOG2 = $clog2(AXI_DATA_BITS / 64);  // words of a beat
  localparam int unsigned BYTES_LOG2 = LANES_LOG2 + 3;
  localparam int unsigned BEATS_LOG2 = 6 - BYTES_LOG2;              // of a line

  // ---- Addresses ----
  // Yosys knows no structure inside a generate block.
  logic        unused_writes;
  logic [57:0] read_line;
  assign read_line     = lines_i.read_line;
  assign unused_writes = ^{lines_i, descriptor_i};
  logic [2:0] wanted, grant;
  logic       free, start, ar_valid_q;
  assign wanted = {lines_i.read_valid && EN_LINES, command_i.valid, descriptor_i.read_valid};
  assign free   = !ar_valid_q || arready_i;
  assign start  = may_start_i && free && |wanted;
  fair_grant #(.USERS(3), .PATIENCE(system_pkg::PATIENCE)) u_grant (
    .clk_i, .rst_ni, .valid_i(wanted), .take_i(start), .grant_o(grant)
  );
  assign {line_read_ready_o, command_o.ready, descriptor_o.ready} = start ? grant : 3'd0;

  logic [63:0]     address, address_q;
  logic [USER-1:0] user;
  logic [USER:0]   id_q;
  logic [7:0]      len, len_q;
  logic [6:0]      last_word;
  logic [5:0]      command_beats_minus1;
  assign last_word            = {1'b0, command_i.address[8:3]} + command_i.words - 7'd1;
  assign command_beats_minus1 = (last_word[5:0] >> LANES_LOG2) - (command_i.address[8:3] >> LANES_LOG2);
  always_comb begin
    if (grant[0]) begin
      address = {descriptor_i.place, 4'd0};
      user    = system_pkg::ID_DESCRIPTOR;
      len     = (AXI_DATA_BITS == 64) ? 8'd1 : 8'd0;
    end else if (grant[1]) begin
      address = {command_i.address, 3'd0};
      user    = system_pkg::ID_COMMAND;
      len     = mutations_pkg::AXI_CROSS_PAGES ? 8'(command_i.words) - 8'd1 : 8'(command_beats_minus1);
    end else begin
      address = {read_line, 6'd0};
      user    = {1'b1, lines_i.read_id};
      len     = 8'((1 << BEATS_LOG2) - 1);
    end
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni)        ar_valid_q <= 1'b0;
    else if (start)     ar_valid_q <= 1'b1;
    else if (arready_i) ar_valid_q <= 1'b0;
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      address_q <= {address[63:BYTES_LOG2], {BYTES_LOG2{1'b0}}};
      id_q      <= {epoch_i, user};
      len_q     <= len;
    end
  end
  logic withdrawn_q;  // seeded fault: an address is offered every other cycle
  always_ff @(posedge clk_i) withdrawn_q <= ar_o.valid && !arready_i && mutations_pkg::AXI_WITHDRAW;
  assign ar_o.valid = ar_valid_q && !withdrawn_q;
  assign ar_o.id    = id_q;
  assign ar_o.addr  = address_q;
  assign ar_o.len   = len_q;
  assign ar_o.size  = 3'(BYTES_LOG2);
  assign ar_o.burst = mutations_pkg::AXI_FIXED_BURST ? 2'b00 : system_pkg::INCR;

  // ---- What is under way ----
  logic [5:0] pending_q, late_q;  // eight bursts of commands, a descriptor, lines
  logic       fresh, ended, ended_late;
  assign fresh      = r_i.valid && (r_i.id[USER] == epoch_i || mutations_pkg::AXI_FORGET_EPOCH);
  assign ended      = fresh && rlast_i;
  assign ended_late = r_i.valid && !fresh && rlast_i && late_q != '0;
  assign pending_o  = pending_q != '0;
  assign late_o     = late_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pending_q <= '0;
      late_q    <= '0;
    end else if (give_up_i) begin
      pending_q <= '0;
      late_q    <= pending_q - 6'(ended);
    end else begin
      pending_q <= pending_q + 6'(start) - 6'(ended && pending_o);
      late_q    <= late_q - 6'(ended_late);
    end
  end

  // ---- Answers ----
  logic            good;
  logic [USER-1:0] answered;
  assign answered          = r_i.id[USER-1:0];
  assign good              = fresh && (!r_i.resp[1] || mutations_pkg::AXI_IGNORE_ERRORS) && core_rst_ni;
  assign descriptor_o.beat = good && answered == system_pkg::ID_DESCRIPTOR;
  assign command_o.beat    = good && answered == system_pkg::ID_COMMAND;
  assign beat_o            = rdata_i;
  assign beat_last_o       = rlast_i;

  logic        line_active;
  logic [63:0] line_oldest, line_address;
  if (EN_LINES) begin : gen_lines
    logic [LINE_IDS_LOG2-1:0] line_id;
    axi_read_lines #(.AXI_DATA_BITS(AXI_DATA_BITS), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_lines (
      .clk_i, .rst_ni(core_rst_ni), .start_i(line_read_ready_o), .line_i(read_line), .id_i(user[LINE_IDS_LOG2-1:0]),
      .beat_valid_i(good && answered[USER-1]), .beat_last_i(rlast_i), .beat_id_i(answered[LINE_IDS_LOG2-1:0]),
      .beat_i(rdata_i), .beat_address_o(line_address), .active_o(line_active), .oldest_o(line_oldest),
      .valid_o(line_data_valid_o), .id_o(line_id), .data_o(line_data_o)
    );
    assign line_data_id_o = cache_pkg::LINE_ID'(line_id);
  end else begin : gen_no_lines
    assign line_active       = 1'b0;
    assign line_oldest       = '0;
    assign line_address      = '0;
    assign line_data_valid_o = 1'b0;
    assign line_data_id_o    = '0;
    assign line_data_o       = '0;
  end

  // ---- Timeout and faults ----
  assign active_o = pending_o || |wanted;
  always_comb begin
    if (descriptor_i.read_active) active_address_o = {descriptor_i.place, 4'd0};
    else if (command_i.active)    active_address_o = command_i.oldest;
    else if (line_active)         active_address_o = line_oldest;
    else                          active_address_o = {read_line, 6'd0};
  end
  always_comb begin
    fault_o.valid = fresh && r_i.resp[1] && !mutations_pkg::AXI_IGNORE_ERRORS;
    fault_o.code  = r_i.resp[0] ? 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_READ_DECERR)
                                : 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_READ_SLVERR);
    case (answered)
      system_pkg::ID_DESCRIPTOR: fault_o.address = {descriptor_i.place, 4'd0};
      system_pkg::ID_COMMAND:    fault_o.address = command_i.oldest;
      default:                   fault_o.address = line_address;
    endcase
  end

  logic unused_bits;
  assign unused_bits = ^{last_word[6], address[BYTES_LOG2-1:0]};

endmodule
