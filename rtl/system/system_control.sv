// SPDX-License-Identifier: Apache-2.0
// Stop and soft reset: keeps the first error, holds the core in reset until the bus is quiet or given up, numbers the
// epochs (docs/system.md, "Errors", "Soft reset").

module system_control (
  input  logic               clk_i,
  input  logic               rst_ni,
  // Faults, the first of them counts; the job under way.
  input  system_pkg::fault_t read_fault_i,
  input  system_pkg::fault_t write_fault_i,
  input  system_pkg::fault_t timeout_fault_i,
  input  system_pkg::fault_t job_fault_i,
  input  logic [15:0]        job_i,
  output logic               stop_o,           // stops in this cycle
  output logic               stopped_o,
  output logic [31:0]        error_status_o,
  output logic [63:0]        error_address_o,
  // Soft reset.
  input  logic               soft_reset_i,     // asked for; not while one goes on
  input  logic [31:0]        axi_timeout_i,
  input  logic               pending_i,        // transactions of this epoch are under way
  input  logic               late_i,           // answers of the epoch before are due
  input  logic               moved_i,          // a channel of the bus moves
  output logic               resetting_o,
  output logic               core_rst_no,      // of all that is not the bus or a register
  output logic               give_up_o,        // in this cycle transactions under way become late
  output logic               epoch_o,
  output logic               may_start_o       // transactions
);

  localparam logic [31:0] LONGEST_PAUSE = 32'd65536;

  // ---- Errors ----
  system_pkg::fault_t fault;
  logic               stopped_q;
  logic [7:0]         code_q;
  logic [15:0]        job_q;
  logic [63:0]        address_q;
  always_comb begin
    if (read_fault_i.valid)         fault = read_fault_i;
    else if (write_fault_i.valid)   fault = write_fault_i;
    else if (timeout_fault_i.valid) fault = timeout_fault_i;
    else                            fault = job_fault_i;
  end
  assign stop_o          = fault.valid && !stopped_q && !resetting_o;
  assign stopped_o       = stopped_q;
  assign error_status_o  = {job_q, 8'd0, code_q};
  assign error_address_o = address_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      stopped_q <= 1'b0;
      code_q    <= '0;
      job_q     <= '0;
      address_q <= '0;
    end else if (soft_reset_i) begin
      stopped_q <= 1'b0;
    end else if (stop_o) begin
      stopped_q <= 1'b1;
      code_q    <= fault.code;
      job_q     <= job_i;
      address_q <= fault.address;
    end
  end

  // ---- Soft reset ----
  logic        resetting_q, epoch_q, over;
  logic [31:0] left_q, limit_q;  // cycles without a move
  logic [31:0] limit;
  assign limit       = (axi_timeout_i == '0) ? LONGEST_PAUSE : axi_timeout_i;
  assign over        = left_q == '0;
  assign resetting_o = resetting_q;
  assign core_rst_no = rst_ni && !resetting_q;
  assign give_up_o   = resetting_q && over && pending_i;
  assign epoch_o     = epoch_q;
  assign may_start_o = !stopped_q && !resetting_q && !soft_reset_i;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      resetting_q <= 1'b0;
      epoch_q     <= 1'b0;
      left_q      <= '0;
      limit_q     <= '0;
    end else if (soft_reset_i) begin
      resetting_q <= 1'b1;
      left_q      <= limit;
      limit_q     <= limit;
    end else if (resetting_q) begin
      if (moved_i)    left_q <= limit_q;
      else if (!over) left_q <= left_q - 32'd1;
      if (over || (!pending_i && !late_i)) resetting_q <= 1'b0;
      if (give_up_o) epoch_q <= !epoch_q;
    end
  end

endmodule
