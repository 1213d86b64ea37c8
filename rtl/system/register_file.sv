// SPDX-License-Identifier: Apache-2.0
// The registers of docs/registers.md: what software may write when, what it reads, interrupts. Offsets and fields come from
// the generated package.

module register_file #(
  parameter logic [31:0] FEATURES        = '0,
  parameter logic [31:0] WIDTHS_VOXEL    = '0,
  parameter logic [31:0] WIDTHS_PLANE    = '0,
  parameter logic [31:0] WIDTHS_TOPOLOGY = '0,
  parameter logic [31:0] WIDTHS_SLB      = '0,
  parameter logic [31:0] WIDTHS_POINT    = '0,
  parameter logic [31:0] WIDTHS_MEMORY   = '0
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  // From axil_slave.
  input  logic                write_i,
  input  logic [11:0]         write_offset_i,
  input  logic [31:0]         write_data_i,
  output logic                write_known_o,
  input  logic [11:0]         read_offset_i,
  output logic [31:0]         read_data_o,
  output logic                read_known_o,
  // State of the hardware.
  input  logic                idle_i,
  input  logic                untouched_i,     // no command word was taken since reset
  input  logic                result_blocked_i,
  input  logic                stopped_i,
  input  logic                late_i,
  input  logic                resetting_i,
  input  logic [31:0]         error_status_i,
  input  logic [63:0]         error_address_i,
  input  logic [23:0]         job_flags_i,
  // What happens.
  input  logic                stop_i,          // the hardware stops
  input  logic                job_done_i,
  input  logic                interrupt_i,     // the job wants to be told of
  input  logic                result_full_i,
  input  logic                tail_step_i,     // a descriptor is finished
  input  logic [3:0]          head_step_i,     // so many results lie in memory
  // Counters.
  output logic [7:0]          counter_index_o,
  input  logic [63:0]         counter_value_i,
  output logic                snapshot_o,
  // Settings.
  output logic                soft_reset_o,    // asked for in this cycle; the registers reset themselves until it is over
  output logic                enable_o,
  output logic                source_o,
  output logic [31:0]         axi_timeout_o,
  output logic [63:0]         plane_base_o,
  output system_pkg::ring_t   command_ring_o,
  output system_pkg::ring_t   result_ring_o,
  output logic                irq_o
);

  // ---- Which writes count ----
  logic [31:0] write_offset, read_offset;
  logic        setup, heed, heed_setup, heed_status;
  assign write_offset = 32'(write_offset_i);
  assign read_offset  = 32'(read_offset_i);
  assign setup        = !enable_o && idle_i;
  assign heed_status  = write_i && !resetting_i;
  assign heed         = heed_status && !stopped_i;
  assign heed_setup   = heed && setup;
  assign soft_reset_o = heed_status && write_offset == gnomon_registers_pkg::GNOMON_RESET_OFFSET &&
                        (write_data_i & gnomon_registers_pkg::GNOMON_RESET_SOFT_RESET_MASK) != '0;
  assign snapshot_o   = heed && write_offset == gnomon_registers_pkg::GNOMON_SNAPSHOT_OFFSET &&
                        (write_data_i & gnomon_registers_pkg::GNOMON_SNAPSHOT_TAKE_MASK) != '0;

  // ---- Settings and counts ----
  logic        enable_q, source_q;
  logic [31:0] timeout_q, jobs_done_q;
  logic [51:0] plane_page_q;
  logic [63:0] command_base_q, result_base_q;
  logic [4:0]  command_log2_q, result_log2_q;
  logic [31:0] command_head_q, command_tail_q, result_head_q, result_tail_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || soft_reset_o || resetting_i) begin
      enable_q       <= 1'b0;
      source_q       <= 1'b0;
      timeout_q      <= gnomon_registers_pkg::GNOMON_AXI_TIMEOUT_RESET;
      plane_page_q   <= '0;
      command_base_q <= '0;
      command_log2_q <= '0;
      command_head_q <= '0;
      command_tail_q <= '0;
      result_base_q  <= '0;
      result_log2_q  <= '0;
      result_head_q  <= '0;
      result_tail_q  <= '0;
      jobs_done_q    <= '0;
    end else begin
      command_tail_q <= command_tail_q + 32'(tail_step_i);
      result_head_q  <= result_head_q + 32'(head_step_i);
      jobs_done_q    <= jobs_done_q + 32'(job_done_i);
      if (heed) begin
        case (write_offset)
          gnomon_registers_pkg::GNOMON_CONTROL_OFFSET: begin
            enable_q <= write_data_i[0];
            if (idle_i) source_q <= write_data_i[1];
          end
          gnomon_registers_pkg::GNOMON_AXI_TIMEOUT_OFFSET:  timeout_q <= write_data_i;
          gnomon_registers_pkg::GNOMON_COMMAND_HEAD_OFFSET: command_head_q <= write_data_i;
          gnomon_registers_pkg::GNOMON_RESULT_TAIL_OFFSET:  result_tail_q <= write_data_i;
          default: ;
        endcase
      end
      if (heed_setup && untouched_i) begin
        case (write_offset)
          gnomon_registers_pkg::GNOMON_PLANE_BASE_LOW_OFFSET:  plane_page_q[19:0] <= write_data_i[31:12];
          gnomon_registers_pkg::GNOMON_PLANE_BASE_HIGH_OFFSET: plane_page_q[51:20] <= write_data_i;
          default: ;
        endcase
      end
      if (heed_setup) begin
        case (write_offset)
          gnomon_registers_pkg::GNOMON_COMMAND_BASE_LOW_OFFSET:  command_base_q[31:0] <= write_data_i;
          gnomon_registers_pkg::GNOMON_COMMAND_BASE_HIGH_OFFSET: command_base_q[63:32] <= write_data_i;
          gnomon_registers_pkg::GNOMON_COMMAND_SIZE_OFFSET:      command_log2_q <= write_data_i[4:0];
          gnomon_registers_pkg::GNOMON_COMMAND_TAIL_OFFSET:      command_tail_q <= write_data_i;
          gnomon_registers_pkg::GNOMON_RESULT_BASE_LOW_OFFSET:   result_base_q[31:0] <= write_data_i;
          gnomon_registers_pkg::GNOMON_RESULT_BASE_HIGH_OFFSET:  result_base_q[63:32] <= write_data_i;
          gnomon_registers_pkg::GNOMON_RESULT_SIZE_OFFSET:       result_log2_q <= write_data_i[4:0];
          gnomon_registers_pkg::GNOMON_RESULT_HEAD_OFFSET:       result_head_q <= write_data_i;
          default: ;
        endcase
      end
    end
  end
  assign enable_o       = enable_q;
  assign source_o       = source_q;
  assign axi_timeout_o  = timeout_q;
  assign plane_base_o   = {plane_page_q, 12'd0};
  assign command_ring_o = {command_base_q, command_log2_q, command_head_q, command_tail_q};
  assign result_ring_o  = {result_base_q, result_log2_q, result_head_q, result_tail_q};

  // ---- Interrupts: an event wins over the write that clears its bit ----
  logic [2:0] raised, cleared, interrupt_status_q, interrupt_enable_q;
  assign raised  = {stop_i, result_full_i, job_done_i && interrupt_i};
  assign cleared = (heed_status && write_offset == gnomon_registers_pkg::GNOMON_INTERRUPT_STATUS_OFFSET) ? write_data_i[2:0] : '0;
  assign irq_o   = (interrupt_status_q & interrupt_enable_q) != '0;
  always_ff @(posedge clk_i) begin
    if (!rst_ni || soft_reset_o || resetting_i) begin
      interrupt_status_q <= '0;
      interrupt_enable_q <= '0;
    end else begin
      interrupt_status_q <= (interrupt_status_q & ~cleared) | raised;
      if (heed && write_offset == gnomon_registers_pkg::GNOMON_INTERRUPT_ENABLE_OFFSET) interrupt_enable_q <= write_data_i[2:0];
    end
  end

  // ---- Reading ----
  logic write_counter, read_counter;
  register_known u_write_known (.offset_i(write_offset_i), .known_o(write_known_o), .counter_o(write_counter));
  register_known u_read_known (.offset_i(read_offset_i), .known_o(read_known_o), .counter_o(read_counter));
  assign counter_index_o = read_offset_i[10:3] - 8'(gnomon_registers_pkg::GNOMON_COUNTER_LOW_OFFSET >> 3);

  always_comb begin
    case (read_offset)
      gnomon_registers_pkg::GNOMON_ID_OFFSET:                 read_data_o = gnomon_registers_pkg::GNOMON_ID_RESET;
      gnomon_registers_pkg::GNOMON_VERSION_OFFSET:            read_data_o = gnomon_registers_pkg::GNOMON_VERSION_RESET;
      gnomon_registers_pkg::GNOMON_FEATURES_OFFSET:           read_data_o = FEATURES;
      gnomon_registers_pkg::GNOMON_WIDTHS_VOXEL_OFFSET:       read_data_o = WIDTHS_VOXEL;
      gnomon_registers_pkg::GNOMON_WIDTHS_PLANE_OFFSET:       read_data_o = WIDTHS_PLANE;
      gnomon_registers_pkg::GNOMON_WIDTHS_TOPOLOGY_OFFSET:    read_data_o = WIDTHS_TOPOLOGY;
      gnomon_registers_pkg::GNOMON_WIDTHS_SLB_OFFSET:         read_data_o = WIDTHS_SLB;
      gnomon_registers_pkg::GNOMON_WIDTHS_POINT_OFFSET:       read_data_o = WIDTHS_POINT;
      gnomon_registers_pkg::GNOMON_WIDTHS_MEMORY_OFFSET:      read_data_o = WIDTHS_MEMORY;
      gnomon_registers_pkg::GNOMON_CONTROL_OFFSET:            read_data_o = {30'd0, source_q, enable_q};
      gnomon_registers_pkg::GNOMON_RESET_OFFSET:              read_data_o = 32'(resetting_i);
      gnomon_registers_pkg::GNOMON_STATUS_OFFSET:             read_data_o = {28'd0, late_i, stopped_i, result_blocked_i, idle_i};
      gnomon_registers_pkg::GNOMON_AXI_TIMEOUT_OFFSET:        read_data_o = timeout_q;
      gnomon_registers_pkg::GNOMON_PLANE_BASE_LOW_OFFSET:     read_data_o = plane_base_o[31:0];
      gnomon_registers_pkg::GNOMON_PLANE_BASE_HIGH_OFFSET:    read_data_o = plane_base_o[63:32];
      gnomon_registers_pkg::GNOMON_COMMAND_BASE_LOW_OFFSET:   read_data_o = command_base_q[31:0];
      gnomon_registers_pkg::GNOMON_COMMAND_BASE_HIGH_OFFSET:  read_data_o = command_base_q[63:32];
      gnomon_registers_pkg::GNOMON_COMMAND_SIZE_OFFSET:       read_data_o = 32'(command_log2_q);
      gnomon_registers_pkg::GNOMON_COMMAND_HEAD_OFFSET:       read_data_o = command_head_q;
      gnomon_registers_pkg::GNOMON_COMMAND_TAIL_OFFSET:       read_data_o = command_tail_q;
      gnomon_registers_pkg::GNOMON_RESULT_BASE_LOW_OFFSET:    read_data_o = result_base_q[31:0];
      gnomon_registers_pkg::GNOMON_RESULT_BASE_HIGH_OFFSET:   read_data_o = result_base_q[63:32];
      gnomon_registers_pkg::GNOMON_RESULT_SIZE_OFFSET:        read_data_o = 32'(result_log2_q);
      gnomon_registers_pkg::GNOMON_RESULT_HEAD_OFFSET:        read_data_o = result_head_q;
      gnomon_registers_pkg::GNOMON_RESULT_TAIL_OFFSET:        read_data_o = result_tail_q;
      gnomon_registers_pkg::GNOMON_INTERRUPT_STATUS_OFFSET:   read_data_o = 32'(interrupt_status_q);
      gnomon_registers_pkg::GNOMON_INTERRUPT_ENABLE_OFFSET:   read_data_o = 32'(interrupt_enable_q);
      gnomon_registers_pkg::GNOMON_ERROR_STATUS_OFFSET:       read_data_o = error_status_i;
      gnomon_registers_pkg::GNOMON_ERROR_ADDRESS_LOW_OFFSET:  read_data_o = error_address_i[31:0];
      gnomon_registers_pkg::GNOMON_ERROR_ADDRESS_HIGH_OFFSET: read_data_o = error_address_i[63:32];
      gnomon_registers_pkg::GNOMON_JOBS_DONE_OFFSET:          read_data_o = jobs_done_q;
      gnomon_registers_pkg::GNOMON_JOB_FLAGS_OFFSET:          read_data_o = 32'(job_flags_i);
      default: begin
        if (!read_counter)         read_data_o = '0;
        else if (read_offset_i[2]) read_data_o = counter_value_i[63:32];
        else                       read_data_o = counter_value_i[31:0];
      end
    endcase
  end

  logic unused_counter;
  assign unused_counter = write_counter;

endmodule
