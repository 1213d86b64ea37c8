// SPDX-License-Identifier: Apache-2.0
// Gnomon on a bus: the core behind registers, rings in memory or stream ports, one AXI4 master and one interrupt
// (docs/system.md).

module gnomon_top #(
  // Those of gnomon_core.
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_VPU_OFFSET    = 1'b1,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  parameter bit          EN_VPU_TOPOLOGY  = 1'b0,
  parameter int unsigned SUB_BITS         = 4,
  parameter int unsigned SPAN_LOG2        = 4,
  parameter int unsigned NODES_LOG2       = 20,
  parameter int unsigned QUADS_LOG2       = 18,
  parameter bit          EN_FRAME_BUFFER  = 1'b0,
  parameter int unsigned FRAME_LAYERS_LOG2 = 0,
  parameter bit          EN_SLB           = 1'b0,
  parameter int unsigned SLB_PLANE_LOG2   = 8,
  parameter int unsigned FRAC_BITS        = 7,
  parameter int unsigned SLOPE_BITS       = 7,
  parameter int unsigned FRAGS_PER_PIXEL  = 2,
  parameter int unsigned SUBPIXEL_BITS    = 10,
  parameter int unsigned QUERY_BITS       = 10,
  parameter int unsigned SLB_ROUNDING     = 0,
  parameter int unsigned SLB_DIVIDERS     = 2,
  parameter int unsigned MEM_LATENCY      = 1,
  parameter int unsigned CACHE_LOG2       = 0,
  parameter int unsigned LINE_IDS_LOG2    = 4,
  parameter int unsigned MEM_STALL_SEED   = 0,
  // The bus.
  parameter int unsigned AXI_DATA_BITS    = 64,
  // Derived; not to be overridden.
  parameter int unsigned AXI_ID_BITS      = LINE_IDS_LOG2 + 2
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,           // synchronous
  output logic                       irq_o,
  // Registers, AXI4-Lite.
  input  logic                       s_axil_awvalid_i,
  output logic                       s_axil_awready_o,
  input  logic [11:0]                s_axil_awaddr_i,
  input  logic                       s_axil_wvalid_i,
  output logic                       s_axil_wready_o,
  input  logic [31:0]                s_axil_wdata_i,
  input  logic [3:0]                 s_axil_wstrb_i,
  output logic                       s_axil_bvalid_o,
  input  logic                       s_axil_bready_i,
  output logic [1:0]                 s_axil_bresp_o,
  input  logic                       s_axil_arvalid_i,
  output logic                       s_axil_arready_o,
  input  logic [11:0]                s_axil_araddr_i,
  output logic                       s_axil_rvalid_o,
  input  logic                       s_axil_rready_i,
  output logic [31:0]                s_axil_rdata_o,
  output logic [1:0]                 s_axil_rresp_o,
  // Memory, AXI4.
  output logic                       m_axi_arvalid_o,
  input  logic                       m_axi_arready_i,
  output logic [AXI_ID_BITS-1:0]     m_axi_arid_o,
  output logic [63:0]                m_axi_araddr_o,
  output logic [7:0]                 m_axi_arlen_o,
  output logic [2:0]                 m_axi_arsize_o,
  output logic [1:0]                 m_axi_arburst_o,
  input  logic                       m_axi_rvalid_i,
  output logic                       m_axi_rready_o,
  input  logic [AXI_ID_BITS-1:0]     m_axi_rid_i,
  input  logic [AXI_DATA_BITS-1:0]   m_axi_rdata_i,
  input  logic [1:0]                 m_axi_rresp_i,
  input  logic                       m_axi_rlast_i,
  output logic                       m_axi_awvalid_o,
  input  logic                       m_axi_awready_i,
  output logic [AXI_ID_BITS-1:0]     m_axi_awid_o,
  output logic [63:0]                m_axi_awaddr_o,
  output logic [7:0]                 m_axi_awlen_o,
  output logic [2:0]                 m_axi_awsize_o,
  output logic [1:0]                 m_axi_awburst_o,
  output logic                       m_axi_wvalid_o,
  input  logic                       m_axi_wready_i,
  output logic [AXI_DATA_BITS-1:0]   m_axi_wdata_o,
  output logic [AXI_DATA_BITS/8-1:0] m_axi_wstrb_o,
  output logic                       m_axi_wlast_o,
  input  logic                       m_axi_bvalid_i,
  output logic                       m_axi_bready_o,
  input  logic [AXI_ID_BITS-1:0]     m_axi_bid_i,
  input  logic [1:0]                 m_axi_bresp_i,
  // Commands and results, AXI4-Stream.
  input  logic                       s_axis_tvalid_i,
  output logic                       s_axis_tready_o,
  input  logic [63:0]                s_axis_tdata_i,
  output logic                       m_axis_tvalid_o,
  input  logic                       m_axis_tready_i,
  output logic [63:0]                m_axis_tdata_o
);

  if (AXI_DATA_BITS != 64 && AXI_DATA_BITS != 128 && AXI_DATA_BITS != 256 && AXI_DATA_BITS != 512) begin : gen_refuse
    $error("AXI_DATA_BITS is none of 64, 128, 256, 512");
  end
  if (system_pkg::USER != cache_pkg::LINE_ID + 1) begin : gen_refuse_ids  // Yosys lets no package use another one
    $error("system_pkg::USER is not the width of a line's id and the bit before it");
  end

  localparam bit CACHED = CACHE_LOG2 != 0;

  // ---- Ports by channel ----
  system_pkg::axil_want_t    axil_want;
  system_pkg::axil_give_t    axil_give;
  system_pkg::axi_address_t  ar, aw;
  system_pkg::axi_answer_t   r, b;
  logic [system_pkg::USER:0] ar_id, aw_id;
  assign axil_want = {s_axil_awvalid_i, s_axil_awaddr_i, s_axil_wvalid_i, s_axil_wdata_i, s_axil_wstrb_i, s_axil_bready_i,
                      s_axil_arvalid_i, s_axil_araddr_i, s_axil_rready_i};
  assign {s_axil_awready_o, s_axil_wready_o, s_axil_bvalid_o, s_axil_bresp_o, s_axil_arready_o, s_axil_rvalid_o,
          s_axil_rdata_o, s_axil_rresp_o} = axil_give;
  // Of a line's id, as many bits as there are.
  assign {m_axi_arvalid_o, ar_id, m_axi_araddr_o, m_axi_arlen_o, m_axi_arsize_o, m_axi_arburst_o} = ar;
  assign {m_axi_awvalid_o, aw_id, m_axi_awaddr_o, m_axi_awlen_o, m_axi_awsize_o, m_axi_awburst_o} = aw;
  assign m_axi_arid_o   = {ar_id[system_pkg::USER-:2], ar_id[LINE_IDS_LOG2-1:0]};
  assign m_axi_awid_o   = {aw_id[system_pkg::USER-:2], aw_id[LINE_IDS_LOG2-1:0]};
  assign r              = {m_axi_rvalid_i, m_axi_rid_i[AXI_ID_BITS-1-:2],
                           cache_pkg::LINE_ID'(m_axi_rid_i[LINE_IDS_LOG2-1:0]), m_axi_rresp_i};
  assign b              = {m_axi_bvalid_i, m_axi_bid_i[AXI_ID_BITS-1-:2],
                           cache_pkg::LINE_ID'(m_axi_bid_i[LINE_IDS_LOG2-1:0]), m_axi_bresp_i};
  assign m_axi_rready_o = 1'b1;
  assign m_axi_bready_o = 1'b1;

  // ---- Registers ----
  logic              enable, source, idle, untouched, snapshot, irq_job, job_done, tail_step, result_full, result_blocked;
  logic              soft_reset, resetting, stopped, stop, late, core_rst_n, may_start, epoch, give_up, pending;
  logic              moved;
  logic [3:0]        head_step;
  logic [7:0]        counter_index;
  logic [15:0]       job;
  logic [23:0]       job_flags;
  logic [31:0]       axi_timeout, error_status;
  logic [63:0]       counter_value, error_address, plane_base;
  system_pkg::ring_t command_ring, result_ring;
  register_block #(
    .FEATURES({13'd0, 2'b11, CACHED, 11'd0, EN_FRAME_BUFFER, EN_PERSPECTIVE, EN_VPU_TOPOLOGY, EN_VPU_OFFSET, EN_SLB}),
    .WIDTHS_VOXEL({8'(MATRIX_FRAC_BITS), 8'(NORMAL_BITS), 8'(VOXEL_FRAC_BITS), 8'(VOXEL_BITS)}),
    .WIDTHS_PLANE({16'd0, 8'(DEPTH_BITS), 8'(PLANE_LOG2)}),
    .WIDTHS_TOPOLOGY(EN_VPU_TOPOLOGY ? {8'(QUADS_LOG2), 8'(NODES_LOG2), 8'(SPAN_LOG2), 8'(SUB_BITS)} : 32'd0),
    .WIDTHS_SLB(EN_SLB ? {8'(FRAGS_PER_PIXEL), 8'(SLOPE_BITS), 8'(FRAC_BITS), 8'(SLB_PLANE_LOG2)} : 32'd0),
    .WIDTHS_POINT(EN_SLB ? {8'd0, 8'(SLB_ROUNDING), 8'(QUERY_BITS), 8'(SUBPIXEL_BITS)} : 32'd0),
    .WIDTHS_MEMORY({8'd0, CACHED ? 8'(LINE_IDS_LOG2) : 8'd0, 8'(CACHE_LOG2), 8'($clog2(AXI_DATA_BITS / 8))})
  ) u_registers (
    .clk_i, .rst_ni, .axil_i(axil_want), .axil_o(axil_give),
    .idle_i(idle), .untouched_i(untouched), .result_blocked_i(result_blocked), .stopped_i(stopped), .late_i(late),
    .resetting_i(resetting), .error_status_i(error_status), .error_address_i(error_address), .job_flags_i(job_flags),
    .stop_i(stop), .job_done_i(job_done), .interrupt_i(irq_job), .result_full_i(result_full), .tail_step_i(tail_step),
    .head_step_i(head_step), .counter_index_o(counter_index), .counter_value_i(counter_value), .snapshot_o(snapshot),
    .soft_reset_o(soft_reset), .enable_o(enable), .source_o(source), .axi_timeout_o(axi_timeout),
    .plane_base_o(plane_base), .command_ring_o(command_ring), .result_ring_o(result_ring), .irq_o
  );

  // ---- Stop and reset ----
  system_pkg::fault_t read_fault, write_fault, timeout_fault, job_fault;
  system_control u_control (
    .clk_i, .rst_ni, .read_fault_i(read_fault), .write_fault_i(write_fault), .timeout_fault_i(timeout_fault),
    .job_fault_i(job_fault), .job_i(job), .stop_o(stop), .stopped_o(stopped), .error_status_o(error_status),
    .error_address_o(error_address), .soft_reset_i(soft_reset), .axi_timeout_i(axi_timeout), .pending_i(pending),
    .late_i(late), .moved_i(moved), .resetting_o(resetting), .core_rst_no(core_rst_n), .give_up_o(give_up), .epoch_o(epoch),
    .may_start_o(may_start)
  );

  // ---- The core ----
  logic                cmd_valid, cmd_ready, res_valid, res_ready, core_idle, in_command, error_given;
  logic                word_awaited, result_awaited;
  logic [63:0]         cmd_data, res_data;
  gnomon_pkg::sticky_t raised;
  cache_pkg::port_want_t lines_want;  // lines of the caches
  cache_pkg::port_give_t lines_give;
  gnomon_core #(
    .VOXEL_BITS(VOXEL_BITS), .VOXEL_FRAC_BITS(VOXEL_FRAC_BITS), .NORMAL_BITS(NORMAL_BITS),
    .MATRIX_FRAC_BITS(MATRIX_FRAC_BITS), .DEPTH_BITS(DEPTH_BITS), .PLANE_LOG2(PLANE_LOG2),
    .EN_VPU_OFFSET(EN_VPU_OFFSET), .EN_PERSPECTIVE(EN_PERSPECTIVE), .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY),
    .SUB_BITS(SUB_BITS), .SPAN_LOG2(SPAN_LOG2), .NODES_LOG2(NODES_LOG2), .QUADS_LOG2(QUADS_LOG2),
    .EN_FRAME_BUFFER(EN_FRAME_BUFFER), .FRAME_LAYERS_LOG2(FRAME_LAYERS_LOG2), .EN_SLB(EN_SLB),
    .SLB_PLANE_LOG2(SLB_PLANE_LOG2), .FRAC_BITS(FRAC_BITS), .SLOPE_BITS(SLOPE_BITS), .FRAGS_PER_PIXEL(FRAGS_PER_PIXEL),
    .SUBPIXEL_BITS(SUBPIXEL_BITS), .QUERY_BITS(QUERY_BITS), .SLB_ROUNDING(SLB_ROUNDING), .SLB_DIVIDERS(SLB_DIVIDERS),
    .MEM_LATENCY(MEM_LATENCY), .CACHE_LOG2(CACHE_LOG2), .LINE_IDS_LOG2(LINE_IDS_LOG2), .MEM_STALL_SEED(MEM_STALL_SEED),
    .EN_BUS(1'b1)
  ) u_core (
    .clk_i, .rst_ni(core_rst_n), .cmd_valid_i(cmd_valid), .cmd_ready_o(cmd_ready), .cmd_data_i(cmd_data),
    .res_valid_o(res_valid), .res_ready_i(res_ready), .res_data_o(res_data), .counter_index_i(counter_index),
    .counter_value_o(counter_value), .idle_o(core_idle), .counter_snapshot_i(snapshot), .word_awaited_i(word_awaited),
    .result_awaited_i(result_awaited), .in_command_o(in_command), .error_given_o(error_given), .raised_o(raised),
    .plane_base_i(plane_base[63:12]), .lines_o(lines_want), .lines_i(lines_give)
  );

  // ---- Rings ----
  system_pkg::descriptor_want_t descriptor_want;
  system_pkg::command_want_t    command_want;
  system_pkg::result_want_t     result_want;
  system_pkg::read_give_t       descriptor_read, command_read;
  system_pkg::write_give_t      completion_write, result_write;
  logic                         command_ring_good, result_ring_good, fetch_start, fetch_busy, fetch_waiting, dma_idle;
  logic                         dma_waiting, results_empty, result_waiting, beat_last;
  logic                         ring_word_valid, ring_word_ready, ring_result_ready;
  logic [31:0]                  fetch_words;
  logic [63:3]                  fetch_address;
  logic [63:0]                  ring_word;
  logic [511:0]                 result_data;
  logic [AXI_DATA_BITS-1:0]     beat;
  ring_check #(.PLACE_LOG2(system_pkg::DESCRIPTOR_LOG2), .LOG2_MIN(1), .LOG2_MAX(16)) u_command_ring (
    .ring_i(command_ring), .good_o(command_ring_good)
  );
  ring_check #(.PLACE_LOG2(system_pkg::WORD_LOG2), .LOG2_MIN(6), .LOG2_MAX(28)) u_result_ring (
    .ring_i(result_ring), .good_o(result_ring_good)
  );
  descriptor_dma #(.AXI_DATA_BITS(AXI_DATA_BITS)) u_descriptors (
    .clk_i, .rst_ni(core_rst_n), .run_i(enable && !source), .stopped_i(stopped), .command_ring_i(command_ring),
    .rings_good_i(command_ring_good && result_ring_good), .want_o(descriptor_want), .read_i(descriptor_read),
    .write_i(completion_write), .beat_last_i(beat_last), .beat_i(beat), .fetch_start_o(fetch_start),
    .fetch_address_o(fetch_address), .fetch_words_o(fetch_words),
    .fetch_busy_i(fetch_busy), .core_idle_i(core_idle), .in_command_i(in_command), .results_written_i(results_empty),
    .result_head_i(result_ring.head), .error_given_i(error_given), .raised_i(raised), .idle_o(dma_idle),
    .waiting_o(dma_waiting), .tail_step_o(tail_step), .job_done_o(job_done), .interrupt_o(irq_job), .job_o(job),
    .job_flags_o(job_flags), .fault_o(job_fault)
  );
  command_fetch #(.AXI_DATA_BITS(AXI_DATA_BITS)) u_commands (
    .clk_i, .rst_ni(core_rst_n), .start_i(fetch_start), .address_i(fetch_address), .words_i(fetch_words),
    .busy_o(fetch_busy), .waiting_o(fetch_waiting), .want_o(command_want), .read_i(command_read),
    .beat_last_i(beat_last), .beat_i(beat),
    .word_valid_o(ring_word_valid), .word_ready_i(ring_word_ready), .word_o(ring_word)
  );
  result_dma u_results (
    .clk_i, .rst_ni(core_rst_n), .stopped_i(stopped), .ring_i(result_ring), .flush_i(core_idle),
    .result_valid_i(res_valid && !source), .result_ready_o(ring_result_ready), .result_i(res_data),
    .want_o(result_want), .data_o(result_data), .write_i(result_write), .head_step_o(head_step), .empty_o(results_empty),
    .blocked_o(result_blocked), .full_o(result_full), .waiting_o(result_waiting)
  );

  // ---- Rings or ports ----
  logic port_open;
  assign port_open       = enable && source && !stopped;
  assign cmd_valid       = source ? s_axis_tvalid_i && port_open : ring_word_valid;
  assign cmd_data        = source ? s_axis_tdata_i : ring_word;
  assign s_axis_tready_o = cmd_ready && port_open;
  assign ring_word_ready = cmd_ready && !source;
  assign m_axis_tvalid_o = res_valid && source;
  assign m_axis_tdata_o  = res_data;
  assign res_ready       = source ? m_axis_tready_i : ring_result_ready;

  // Waiting for the bus ends a cycle later behind the registers of the core's ports.
  logic word_late, word_late_q, result_late, result_late_q;
  assign word_late      = !source && (dma_waiting || fetch_waiting);
  assign result_late    = !source && result_waiting;
  assign word_awaited   = word_late || word_late_q;
  assign result_awaited = result_late || result_late_q;
  always_ff @(posedge clk_i) begin
    word_late_q   <= core_rst_n && word_late;
    result_late_q <= core_rst_n && result_late;
  end

  // The clear after reset is nothing that software waits for.
  logic untouched_q, active;
  always_ff @(posedge clk_i) begin
    if (!core_rst_n)                 untouched_q <= 1'b1;
    else if (cmd_valid && cmd_ready) untouched_q <= 1'b0;
  end
  assign untouched = untouched_q;
  assign idle      = dma_idle && results_empty && !pending && !active && (core_idle || untouched_q) && !resetting;

  // ---- Memory ----
  axi_master #(.AXI_DATA_BITS(AXI_DATA_BITS), .EN_LINES(CACHED), .LINE_IDS_LOG2(LINE_IDS_LOG2)) u_master (
    .clk_i, .rst_ni, .core_rst_ni(core_rst_n), .may_start_i(may_start), .epoch_i(epoch), .give_up_i(give_up),
    .timeout_i(axi_timeout), .pending_o(pending), .late_o(late), .active_o(active), .moved_o(moved),
    .read_fault_o(read_fault), .write_fault_o(write_fault), .timeout_fault_o(timeout_fault),
    .descriptor_i(descriptor_want), .descriptor_o(descriptor_read), .completion_o(completion_write),
    .command_i(command_want), .command_o(command_read), .beat_o(beat), .beat_last_o(beat_last), .result_i(result_want),
    .result_data_i(result_data), .result_o(result_write), .lines_i(lines_want), .lines_o(lines_give),
    .ar_o(ar), .arready_i(m_axi_arready_i), .r_i(r), .rlast_i(m_axi_rlast_i), .rdata_i(m_axi_rdata_i),
    .aw_o(aw), .awready_i(m_axi_awready_i), .wvalid_o(m_axi_wvalid_o), .wready_i(m_axi_wready_i), .wdata_o(m_axi_wdata_o),
    .wstrb_o(m_axi_wstrb_o), .wlast_o(m_axi_wlast_o), .b_i(b)
  );

  logic unused_bits;
  assign unused_bits = ^{plane_base[11:0], ar_id, aw_id};

endmodule
