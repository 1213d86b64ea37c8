// SPDX-License-Identifier: Apache-2.0
// Stops elaboration, with a message, where a combination of parameters is illegal (docs/vpu.md, docs/vpu-topology.md,
// docs/frame-buffer.md, docs/slb.md and docs/cache.md, "Parameters"); those of a unit that can be left out only where it is built.

module parameter_check #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
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
  parameter int unsigned MEM_STALL_SEED   = 0,
  parameter int unsigned CACHE_LOG2       = 0,
  parameter int unsigned LINE_IDS_LOG2    = 4
);

  localparam int unsigned P = VOXEL_BITS + VOXEL_FRAC_BITS;

  if (VOXEL_BITS < 4 || VOXEL_BITS > 11)
    $error("VOXEL_BITS is out of range 4..11");
  if (VOXEL_FRAC_BITS > 6)
    $error("VOXEL_FRAC_BITS is out of range 0..6");
  if (P > 16)
    $error("VOXEL_BITS + VOXEL_FRAC_BITS is above 16");
  if (NORMAL_BITS < 4 || NORMAL_BITS > 12)
    $error("NORMAL_BITS is out of range 4..12");
  if (3 * (P + NORMAL_BITS) > 63)
    $error("3 (VOXEL_BITS + VOXEL_FRAC_BITS + NORMAL_BITS) is above 63: a voxel does not fit a word");
  if (MATRIX_FRAC_BITS < 12 || MATRIX_FRAC_BITS > 28)
    $error("MATRIX_FRAC_BITS is out of range 12..28");
  if (MATRIX_FRAC_BITS < P + 2)
    $error("MATRIX_FRAC_BITS is below VOXEL_BITS + VOXEL_FRAC_BITS + 2");
  if (DEPTH_BITS < 8 || DEPTH_BITS > 24)
    $error("DEPTH_BITS is out of range 8..24");
  if (PLANE_LOG2 < 4 || PLANE_LOG2 > 12)
    $error("PLANE_LOG2 is out of range 4..12");
  if (MEM_LATENCY < 1 || MEM_LATENCY > 64)
    $error("MEM_LATENCY is out of range 1..64");
  if (MEM_STALL_SEED > 65535)
    $error("MEM_STALL_SEED is out of range 0..65535");
  if (CACHE_LOG2 != 0 && (CACHE_LOG2 < 12 || CACHE_LOG2 > 16))
    $error("CACHE_LOG2 is out of range 12..16 (0: planes on chip)");
  if (LINE_IDS_LOG2 < 3 || LINE_IDS_LOG2 > 5)
    $error("LINE_IDS_LOG2 is out of range 3..5");

  if (EN_VPU_TOPOLOGY) begin : gen_topology
    if (SUB_BITS < 2 || SUB_BITS > 8)
      $error("SUB_BITS is out of range 2..8");
    if (SPAN_LOG2 < 2 || SPAN_LOG2 > 6)
      $error("SPAN_LOG2 is out of range 2..6");
    if (NODES_LOG2 < 4 || NODES_LOG2 > 24)
      $error("NODES_LOG2 is out of range 4..24");
    if (QUADS_LOG2 < 4 || QUADS_LOG2 > 24)
      $error("QUADS_LOG2 is out of range 4..24");
  end

  if (EN_FRAME_BUFFER) begin : gen_frame
    if (FRAME_LAYERS_LOG2 > 3)
      $error("FRAME_LAYERS_LOG2 is out of range 0..3");
    if (3 * VOXEL_BITS + FRAME_LAYERS_LOG2 + 1 > 34)
      $error("3 VOXEL_BITS + FRAME_LAYERS_LOG2 + 1 is above 34: more than 2 GiB of states");
  end

  if (EN_SLB) begin : gen_slb
    if (FRAC_BITS < 3 || FRAC_BITS > 8)
      $error("FRAC_BITS is out of range 3..8");
    if (SLOPE_BITS < 3 || SLOPE_BITS > 9)
      $error("SLOPE_BITS is out of range 3..9");
    if (FRAGS_PER_PIXEL < 1 || FRAGS_PER_PIXEL > 4)
      $error("FRAGS_PER_PIXEL is out of range 1..4");
    if (SLB_PLANE_LOG2 < 3 || SLB_PLANE_LOG2 > 12)
      $error("SLB_PLANE_LOG2 is out of range 3..12");
    if (SUBPIXEL_BITS < FRAC_BITS + 3 || SUBPIXEL_BITS > 16)
      $error("SUBPIXEL_BITS is out of range FRAC_BITS + 3..16");
    if (SUBPIXEL_BITS + FRAC_BITS < SLOPE_BITS + 4)
      $error("SUBPIXEL_BITS is below SLOPE_BITS - FRAC_BITS + 4");
    if (QUERY_BITS < FRAC_BITS + 3 || QUERY_BITS > 16)
      $error("QUERY_BITS is out of range FRAC_BITS + 3..16");
    if (2 * (SLB_PLANE_LOG2 + 2 + SUBPIXEL_BITS) + DEPTH_BITS > 64)
      $error("2 (SLB_PLANE_LOG2 + 2 + SUBPIXEL_BITS) + DEPTH_BITS is above 64: a vertex does not fit a word");
    if (2 * (SLB_PLANE_LOG2 + 2 + QUERY_BITS) + DEPTH_BITS > 64)
      $error("2 (SLB_PLANE_LOG2 + 2 + QUERY_BITS) + DEPTH_BITS is above 64: a query does not fit a word");
    if (SLB_ROUNDING > 1)
      $error("SLB_ROUNDING is out of range 0..1");
    if (SLB_DIVIDERS < 1 || SLB_DIVIDERS > 3)
      $error("SLB_DIVIDERS is out of range 1..3");
  end

endmodule
