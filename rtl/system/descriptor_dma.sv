// SPDX-License-Identifier: Apache-2.0
// Runs the descriptors of the command ring: descriptor, words, at a job's end the completion, then the tail
// (docs/system.md, "Descriptors").

`include "assertions.svh"

module descriptor_dma #(
  parameter int unsigned AXI_DATA_BITS = 64
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         run_i,              // enabled, and the rings are the source
  input  logic                         stopped_i,
  input  system_pkg::ring_t            command_ring_i,
  input  logic                         rings_good_i,
  // Reads of descriptors, writes of completions.
  output system_pkg::descriptor_want_t want_o,
  input  system_pkg::read_give_t       read_i,
  input  system_pkg::write_give_t      write_i,
  input  logic                         beat_last_i,
  input  logic [AXI_DATA_BITS-1:0]     beat_i,
  // Command words.
  output logic                         fetch_start_o,
  output logic [63:3]                  fetch_address_o,
  output logic [31:0]                  fetch_words_o,
  input  logic                         fetch_busy_i,
  // The core and its results.
  input  logic                         core_idle_i,
  input  logic                         in_command_i,
  input  logic                         results_written_i,  // none gathered, none under way
  input  logic [31:0]                  result_head_i,
  input  logic                         error_given_i,
  input  gnomon_pkg::sticky_t          raised_i,
  // What comes of it.
  output logic                         idle_o,             // no descriptor begun
  output logic                         waiting_o,          // for the bus, before a descriptor's words
  output logic                         tail_step_o,
  output logic                         job_done_o,
  output logic                         interrupt_o,        // with job_done_o
  output logic [15:0]                  job_o,              // under way, or NO_JOB
  output logic [23:0]                  job_flags_o,
  output system_pkg::fault_t           fault_o
);

  typedef enum logic [2:0] {StIdle, StAsk, StWait, StCheck, StRun, StDrain, StComplete, StWritten} state_e;
  state_e state_q, state_d;

  // ---- Descriptor ----
  logic [127:0] descriptor_q;
  logic [63:0]  address;
  logic [31:0]  words;
  logic [15:0]  number, flags;
  logic         good, last, wanted;
  assign {flags, number, words, address} = descriptor_q;
  assign good   = (flags & ~(system_pkg::FLAG_LAST | system_pkg::FLAG_INTERRUPT)) == '0 && words != '0 &&
                  address[2:0] == 3'd0;
  assign last   = (flags & system_pkg::FLAG_LAST) != '0;
  assign wanted = command_ring_i.head != command_ring_i.tail;

  // Yosys knows no structure inside a generate block.
  logic        beat_valid;
  logic [31:0] number_in_ring;
  logic [63:4] place;
  assign beat_valid     = read_i.beat;
  assign number_in_ring = command_ring_i.tail & ((32'd1 << command_ring_i.log2) - 32'd1);
  assign place          = command_ring_i.base[63:4] | 60'(number_in_ring);  // the base is aligned to the ring
  assign want_o.place   = place;

  if (AXI_DATA_BITS == 64) begin : gen_two_beats
    always_ff @(posedge clk_i) if (beat_valid) descriptor_q <= {beat_i, descriptor_q[127:64]};
  end else if (AXI_DATA_BITS == 128) begin : gen_one_beat
    always_ff @(posedge clk_i) if (beat_valid) descriptor_q <= beat_i;
  end else begin : gen_part_of_a_beat
    localparam int unsigned PART_BITS = $clog2(AXI_DATA_BITS / 128);
    always_ff @(posedge clk_i) if (beat_valid) descriptor_q <= beat_i[32'(place[4+:PART_BITS])*128+:128];
  end

  // ---- State ----
  logic cut;
  assign cut = state_q == StDrain && core_idle_i && in_command_i;
  always_comb begin
    state_d = state_q;
    case (state_q)
      StIdle:     if (run_i && wanted && rings_good_i) state_d = StAsk;
      StAsk:      if (read_i.ready) state_d = StWait;
      StWait:     if (beat_valid && beat_last_i) state_d = StCheck;
      StCheck:    if (good) state_d = StRun;
      StRun:      if (!fetch_busy_i) state_d = last ? StDrain : StIdle;
      StDrain:    if (core_idle_i && results_written_i && !cut) state_d = StComplete;
      StComplete: if (write_i.ready) state_d = StWritten;
      default:    if (write_i.written) state_d = StIdle;
    endcase
  end
  always_ff @(posedge clk_i) begin
    if (!rst_ni)         state_q <= StIdle;
    else if (!stopped_i) state_q <= state_d;
  end
  assign idle_o             = state_q == StIdle;
  assign waiting_o          = state_q == StAsk || state_q == StWait || state_q == StCheck;
  assign want_o.read_valid  = state_q == StAsk;
  assign want_o.read_active = state_q == StAsk || state_q == StWait;
  assign fetch_start_o      = state_q == StCheck && good && !stopped_i;
  assign fetch_address_o    = address[63:3];
  assign fetch_words_o      = words;
  assign job_done_o         = state_q == StWritten && write_i.written && !stopped_i;
  assign interrupt_o        = (flags & system_pkg::FLAG_INTERRUPT) != '0;
  assign tail_step_o        = job_done_o || (state_q == StRun && !fetch_busy_i && !last && !stopped_i);

  // ---- Job: errors and flags since its first word ----
  logic        in_job_q;
  logic [31:0] errors_q;
  logic [15:0] job_q;
  gnomon_pkg::sticky_t flags_q;
  logic        begins;  // with a job's first descriptor; the units have nothing to do
  assign begins = state_q == StCheck && !in_job_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      in_job_q <= 1'b0;
      errors_q <= '0;
      flags_q  <= '0;
    end else begin
      if (state_q == StCheck) in_job_q <= 1'b1;
      else if (job_done_o)    in_job_q <= 1'b0;
      errors_q <= begins ? '0 : errors_q + 32'(error_given_i);
      flags_q  <= begins ? '0 : flags_q | raised_i;
    end
  end
  always_ff @(posedge clk_i) if (state_q == StCheck) job_q <= number;
  assign job_flags_o = 24'(flags_q);
  always_comb begin
    if (state_q == StCheck) job_o = number;
    else                    job_o = in_job_q ? job_q : system_pkg::NO_JOB;
  end

  assign want_o.write_valid  = state_q == StComplete;
  assign want_o.completion   = {flags | system_pkg::FLAG_COMPLETE, number, errors_q, 8'd0, job_flags_o, result_head_i};
  assign want_o.write_active = state_q == StComplete || state_q == StWritten;

  // ---- Faults of the job itself ----
  always_comb begin
    fault_o.address = '0;
    fault_o.valid   = 1'b1;
    if (state_q == StIdle && run_i && wanted && !rings_good_i)
      fault_o.code = 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_BAD_RING);
    else if (state_q == StCheck && !good)
      fault_o.code = 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_BAD_DESCRIPTOR);
    else begin
      fault_o.code  = 8'(gnomon_registers_pkg::GNOMON_ERROR_CODE_IS_CUT_COMMAND);
      fault_o.valid = cut;
    end
  end

  logic unused_ring;
  assign unused_ring = ^{command_ring_i.base[3:0]};

  `GNOMON_ASSERT(a_beat_expected, !beat_valid || state_q == StWait)
  `GNOMON_ASSERT(a_answer_expected, !write_i.written || state_q == StWritten)

endmodule
