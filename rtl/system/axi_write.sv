// SPDX-License-Identifier: Apache-2.0
// Write channels of the AXI master: one line or part of one after the other, its address and its data at the same time;
// answers by id. After a soft reset what was begun is finished without strobes (docs/system.md, "The master").

`include "assertions.svh"

module axi_write #(
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
  input  system_pkg::result_want_t      result_i,
  input  logic [511:0]                  result_data_i,
  output system_pkg::write_give_t       result_o,
  input  system_pkg::descriptor_want_t  completion_i,  // its writes
  output system_pkg::write_give_t       completion_o,
  // Lines.
  input  cache_pkg::port_want_t         lines_i,       // its writes
  output logic                          line_write_ready_o,
  output logic                          line_written_valid_o,
  output logic [cache_pkg::LINE_ID-1:0] line_written_id_o,
  // AXI.
  output system_pkg::axi_address_t      aw_o,
  input  logic                          awready_i,
  output logic                          wvalid_o,
  input  logic                          wready_i,
  output logic [AXI_DATA_BITS-1:0]      wdata_o,
  output logic [AXI_DATA_BITS/8-1:0]    wstrb_o,
  output logic                          wlast_o,
  input  system_pkg::axi_answer_t       b_i,
  // Where a transaction waits, for a timeout; faults.
  output logic                          active_o,
  output logic [63:0]                   active_address_o,
  output system_pkg::fault_t            fault_o
);

  localparam int unsigned USER       = system_pkg::USER;
  localparam int unsigned LANES_LOG2 = $clog2(AXI_DATA_BITS / 64);  // words of a beat

  // ---- Who goes ----
  // Yosys knows no structure inside a generate block.
  logic        unused_reads;
  logic [57:0] write_line;
  assign write_line   = lines_i.write_line;
  assign unused_reads = ^{lines_i, completion_i};
  logic [2:0] wanted, grant;
  logic       free, start;
  assign wanted = {lines_i.write_valid && EN_LINES, completion_i.write_valid, result_i.valid};
  assign start  = may_start_i && free && |wanted;
  fair_grant #(.USERS(3), .PATIENCE(system_pkg::PATIENCE)) u_grant (
    .clk_i, .rst_ni, .valid_i(wanted), .take_i(start), .grant_o(grant)
  );
  assign {line_write_ready_o, completion_o.ready, result_o.ready} = start ? grant : 3'd0;

  logic [63:6]     line;
  logic [USER-1:0] user;
  logic [2:0]      first, last;
  logic [511:0]    data;
  logic [7:0]      words;   // of the line
  logic [63:0]     strobe;
  assign words = (8'hFF << first) & (8'hFF >> (3'd7 - last));
  for (genvar i = 0; i < 8; i++) begin : gen_strobes
    assign strobe[i*8+:8] = {8{words[i]}};
  end
  always_comb begin
    if (grant[0]) begin
      line  = result_i.line;
      user  = system_pkg::ID_RESULT;
      first = result_i.first;
      last  = result_i.last;
      data  = result_data_i;
    end else if (grant[1]) begin
      line  = completion_i.place[63:6];
      user  = system_pkg::ID_DESCRIPTOR;
      first = {completion_i.place[5:4], 1'b0};
      last  = {completion_i.place[5:4], 1'b1};
      data  = {4{completion_i.completion}};
    end else begin
      line  = write_line;
      user  = {1'b1, lines_i.write_id};
      first = 3'd0;
      last  = 3'd7;
      data  = lines_i.write_data;
    end
  end

  // ---- The burst under way ----
  logic          aw_valid_q, w_valid_q, void_q, beat_taken, is_last;
  logic [63:0]   address_q, strobe_q;
  logic [USER:0] id_q;
  logic [2:0]    beat_q, last_beat_q, first_beat, last_beat, len_q;
  logic [511:0]  data_q;
  assign first_beat = first >> LANES_LOG2;
  assign last_beat  = last >> LANES_LOG2;
  assign is_last    = beat_q == last_beat_q;
  assign beat_taken = w_valid_q && wready_i;
  assign free       = (!aw_valid_q || awready_i) && (!w_valid_q || (beat_taken && is_last));
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      aw_valid_q <= 1'b0;
      w_valid_q  <= 1'b0;
      void_q     <= 1'b0;
    end else begin
      if (start)                      aw_valid_q <= 1'b1;
      else if (awready_i)             aw_valid_q <= 1'b0;
      if (start)                      w_valid_q <= 1'b1;
      else if (beat_taken && is_last) w_valid_q <= 1'b0;
      if (start)                      void_q <= 1'b0;
      else if (!core_rst_ni)          void_q <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start) begin
      address_q   <= {line, 3'(first_beat << LANES_LOG2), 3'd0};
      id_q        <= {epoch_i, user};
      len_q       <= last_beat - first_beat;
      beat_q      <= first_beat;
      last_beat_q <= last_beat;
      data_q      <= data;
      strobe_q    <= strobe;
    end else if (beat_taken) begin
      beat_q <= beat_q + 3'd1;
      if (void_q || !core_rst_ni) strobe_q <= '0;
    end
  end
  logic waited_q;  // seeded fault: an address changes while it waits
  always_ff @(posedge clk_i) waited_q <= aw_o.valid && !awready_i && mutations_pkg::AXI_CHANGE_ADDRESS;
  assign aw_o.valid = aw_valid_q;
  assign aw_o.id    = id_q;
  assign aw_o.addr  = {address_q[63:7], address_q[6] ^ waited_q, address_q[5:0]};
  assign aw_o.len   = 8'(len_q);
  assign aw_o.size  = 3'($clog2(AXI_DATA_BITS / 8));
  assign aw_o.burst = system_pkg::INCR;
  assign wvalid_o   = w_valid_q;
  assign wdata_o    = data_q[32'(beat_q)*AXI_DATA_BITS+:AXI_DATA_BITS];
  assign wstrb_o    = strobe_q[32'(beat_q)*(AXI_DATA_BITS/8)+:AXI_DATA_BITS/8];
  assign wlast_o    = is_last || (mutations_pkg::AXI_LAST_EARLY && beat_q + 3'd1 == last_beat_q);

  // ---- What is under way ----
  logic [6:0] pending_q, late_q;  // 32 bursts of results, a completion, lines
  logic       fresh, ended_late;
  assign fresh      = b_i.valid && (b_i.id[USER] == epoch_i || mutations_pkg::AXI_FORGET_EPOCH);
  assign ended_late = b_i.valid && !fresh && late_q != '0;
  assign pending_o  = pending_q != '0;  // answered after its address and data are taken
  assign late_o     = late_q != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      pending_q <= '0;
      late_q    <= '0;
    end else if (give_up_i) begin
      pending_q <= '0;
      late_q    <= pending_q - 7'(fresh);
    end else begin
      pending_q <= pending_q + 7'(start) - 7'(fresh && pending_q != '0);
      late_q    <= late_q - 7'(ended_late);
    end
  end

  // ---- Answers ----
  logic            good;
  logic [USER-1:0] answered;
  assign answered             = b_i.id[USER-1:0];
  assign good                 = fresh && (!b_i.resp[1] || mutations_pkg::AXI_IGNORE_ERRORS) && core_rst_ni;
  assign result_o.written     = good && answered == system_pkg::ID_RESULT;
  assign completion_o.written = good && answered == system_pkg::ID_DESCRIPTOR;
  assign line_written_valid_o = good && answered[USER-1];
  assign line_written_id_o    = cache_pkg::LINE_ID'(answered[LINE_IDS_LOG2-1:0]);

  logic        line_active;
  logic [63:0] line_oldest, line_address;
  if (EN_LINES) begin : gen_lines
    axi_write_lines #(.LINE_IDS_LOG2(LINE_IDS_LOG2)) u_lines (
      .clk_i, .rst_ni(core_rst_ni), .start_i(line_write_ready_o), .line_i(write_line), .id_i(user[LINE_IDS_LOG2-1:0]),
      .written_i(line_written_valid_o), .written_id_i(answered[LINE_IDS_LOG2-1:0]), .written_address_o(line_address),
      .active_o(line_active), .oldest_o(line_oldest)
    );
  end else begin : gen_no_lines
    assign line_active  = 1'b0;
    assign line_oldest  = '0;
    assign line_address = '0;
  end

  // ---- Timeout and faults ----
  assign active_o = pending_q != '0 || |wanted;
  always_comb begin
    if (result_i.active)                active_address_o = result_i.oldest;
    else if (completion_i.write_active) active_address_o = {completion_i.place, 4'd0};
    else if (line_active)               active_address_o = line_oldest;
    else                                active_address_o = {write_line, 6'd0};
  end
  always_comb begin
    fault_o.valid = fresh && b_i.resp[1] && !mutations_pkg::AXI_IGNORE_ERRORS;
    fault_o.code  = b_i.resp[0] ? 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_WRITE_DECERR)
                                : 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_WRITE_SLVERR);
    case (answered)
      system_pkg::ID_RESULT:     fault_o.address = result_i.oldest;
      system_pkg::ID_DESCRIPTOR: fault_o.address = {completion_i.place, 4'd0};
      default:                   fault_o.address = line_address;
    endcase
  end

endmodule
