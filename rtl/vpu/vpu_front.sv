// SPDX-License-Identifier: Apache-2.0
// Front end of the projection unit, shared by its modes: registers, fields of an item, its place on the plane, and for a
// voxel to resolve its offset point and slopes. Everything that multiplies by the matrix is here. The stages move together,
// when the mode behind says so; an item a cycle. The place is there in stage 3, the offset point two stages later; in
// hardware with the perspective projection both come eight stages later, whichever projection is selected.

module vpu_front #(
  parameter int unsigned VOXEL_BITS       = 8,
  parameter int unsigned VOXEL_FRAC_BITS  = 2,
  parameter int unsigned NORMAL_BITS      = 9,
  parameter int unsigned MATRIX_FRAC_BITS = 22,
  parameter int unsigned DEPTH_BITS       = 20,
  parameter int unsigned PLANE_LOG2       = 9,
  parameter bit          EN_VPU_OFFSET    = 1'b1,
  parameter bit          EN_VPU_TOPOLOGY  = 1'b1,
  parameter bit          EN_PERSPECTIVE   = 1'b0,
  // Derived; not to be overridden.
  parameter int unsigned P         = VOXEL_BITS + VOXEL_FRAC_BITS,
  parameter int unsigned CLEARANCE = gnomon_pkg::clearance_bits(EN_PERSPECTIVE, DEPTH_BITS),
  parameter int unsigned PLACE     = gnomon_pkg::place_bits(PLANE_LOG2)
) (
  input  logic                                       clk_i,
  input  logic                                       rst_ni,
  // Register writes of `word_i`; only while nothing is under way.
  input  logic                                       register_write_i,
  input  logic [gnomon_pkg::REGISTER_INDEX_BITS-1:0] register_index_i,
  output logic [gnomon_pkg::SHIFT_BITS-1:0]          delta_shift_o,
  output logic [gnomon_pkg::MARGIN_BITS-1:0]         margin_squared_o,
  output logic [DEPTH_BITS-1:0]                      delta_max_o,
  // A voxel item is taken when `en_i`, with what it is for; sorted and clearance belong to ITEM_BEAM.
  input  logic                                       en_i,
  input  logic                                       item_valid_i,
  input  logic [63:0]                                word_i,
  input  logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_i,
  input  logic                                       two_sided_i,
  input  logic                                       sorted_i,
  input  logic [CLEARANCE-1:0]                       clearance_i,
  output logic                                       idle_o,         // nothing in any stage
  // The place of an item.
  output logic                                       valid_o,
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      kind_o,
  output logic                                       behind_o,       // the light; the rest means nothing then
  output logic signed [PLACE-1:0]                    u_fine_o, v_fine_o,
  output logic [DEPTH_BITS-1:0]                      depth_o,
  output logic                                       saturated_o,
  // Two stages later, of items to resolve: their offset point.
  output logic                                       moved_valid_o,
  output logic [gnomon_pkg::ITEM_KIND_BITS-1:0]      moved_kind_o,
  output logic                                       sorted_o,
  output logic [DEPTH_BITS-1:0]                      clearance_o,    // that is not in depth_moved_o yet
  output logic                                       moved_behind_o,
  output logic                                       outside_cone_o,
  output logic                                       facing_away_o,
  output logic signed [PLACE-1:0]                    u_moved_o, v_moved_o,
  output logic [DEPTH_BITS-1:0]                      depth_moved_o,
  output gnomon_pkg::slopes_t                        slopes_o,
  output logic [DEPTH_BITS-1:0]                      item_delta_max_o
);

  localparam int unsigned N        = NORMAL_BITS;
  localparam int unsigned F        = MATRIX_FRAC_BITS;
  localparam int unsigned D        = DEPTH_BITS;
  localparam bit          RESOLVES = EN_VPU_OFFSET || EN_VPU_TOPOLOGY;
  localparam int unsigned UV_M     = gnomon_pkg::uv_coefficient_bits(F);
  localparam int unsigned UV_1     = gnomon_pkg::uv_constant_bits(F, P);
  localparam int unsigned UV_ACC   = gnomon_pkg::uv_acc_bits(F, P);
  localparam int unsigned UV_G     = gnomon_pkg::uv_gradient_bits(F, N);
  localparam int unsigned UV_S     = gnomon_pkg::step_bits(UV_G);
  localparam int unsigned D_M      = gnomon_pkg::depth_coefficient_bits(D, P);
  localparam int unsigned D_1      = gnomon_pkg::depth_constant_bits(D, P);
  localparam int unsigned D_ACC    = gnomon_pkg::depth_acc_bits(D, P);
  localparam int unsigned D_AS     = D_ACC - P;
  localparam int unsigned D_G      = gnomon_pkg::depth_gradient_bits(D, P, N);
  localparam int unsigned LIGHT    = gnomon_pkg::light_bits(P);
  // The third row is depth or w: wide enough for what the hardware has of both. T_GS: what of its gradient is lifted.
  localparam int unsigned T_M      = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_M, UV_M) : D_M;
  localparam int unsigned T_1      = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_1, UV_1) : D_1;
  localparam int unsigned T_ACC    = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_ACC, UV_ACC) : D_ACC;
  localparam int unsigned T_G      = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_G, UV_G) : D_G;
  localparam int unsigned T_GS     = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_G - P, UV_G) : D_G - P;
  localparam int unsigned T_S      = gnomon_pkg::step_bits(T_GS);
  localparam int unsigned F_G      = EN_PERSPECTIVE ? gnomon_pkg::max_of(D_G, P + N + 13) : D_G;

  // Stages: of the place, of the offset point, of the turned gradient.
  localparam int unsigned PLACED   = EN_PERSPECTIVE ? 11 : 3;
  localparam int unsigned MOVED    = PLACED + 2;
  localparam int unsigned TURNED   = EN_PERSPECTIVE ? 4 : 3;

  // ---- Registers ----
  logic signed [UV_M-1:0]                    ux, uy, uz, vx, vy, vz;
  logic signed [UV_1-1:0]                    u1, v1;
  logic signed [D_M-1:0]                     dx, dy, dz;
  logic signed [D_1-1:0]                     d1;
  logic signed [T_M-1:0]                     tx, ty, tz;
  logic signed [T_1-1:0]                     t1;
  logic signed [LIGHT-1:0]                   light_x, light_y, light_z;
  logic [gnomon_pkg::OFFSET_FACTOR_BITS-1:0] offset_factor;
  logic [gnomon_pkg::SHIFT_BITS-1:0]         facing_shift, tilt_shift;
  logic                                      perspective;
  vpu_registers #(.POSITION_BITS(P), .MATRIX_FRAC_BITS(F), .DEPTH_BITS(D)) u_registers (
    .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(word_i),
    .ux_o(ux), .uy_o(uy), .uz_o(uz), .u1_o(u1), .vx_o(vx), .vy_o(vy), .vz_o(vz), .v1_o(v1),
    .dx_o(dx), .dy_o(dy), .dz_o(dz), .d1_o(d1), .offset_factor_o(offset_factor), .facing_shift_o(facing_shift),
    .tilt_shift_o(tilt_shift), .delta_shift_o, .margin_squared_o, .delta_max_o
  );

  // ---- What travels along ----
  logic                 two_sided, beam3;
  logic [CLEARANCE-1:0] clearance3, moved_clearance;  // in stage 3; with the offset point
  vpu_travel #(
    .EN_VPU_TOPOLOGY(EN_VPU_TOPOLOGY), .CLEARANCE(CLEARANCE), .PLACED(PLACED), .MOVED(MOVED), .TURNED(TURNED)
  ) u_travel (
    .clk_i, .rst_ni, .en_i, .item_valid_i, .kind_i, .two_sided_i, .sorted_i, .clearance_i, .idle_o, .two_sided_o(two_sided),
    .beam3_o(beam3), .clearance3_o(clearance3), .valid_o, .kind_o, .moved_valid_o, .moved_kind_o, .sorted_o,
    .moved_clearance_o(moved_clearance)
  );

  // ---- Stage 0: fields; stages 1 and 2: M·p ----
  logic [P-1:0]             x, y, z;
  logic signed [N-1:0]      nx, ny, nz;
  logic signed [UV_ACC-1:0] u_acc, v_acc;
  logic signed [T_ACC-1:0]  t_acc;
  vpu_unpack #(.POSITION_BITS(P), .NORMAL_BITS(N)) u_unpack (
    .clk_i, .en_i, .item_i(word_i), .x_o(x), .y_o(y), .z_o(z), .nx_o(nx), .ny_o(ny), .nz_o(nz)
  );
  vpu_project #(.POSITION_BITS(P), .MATRIX_FRAC_BITS(F), .T_M(T_M), .T_1(T_1), .T_ACC(T_ACC)) u_project (
    .clk_i, .en_i, .x_i(x), .y_i(y), .z_i(z), .ux_i(ux), .uy_i(uy), .uz_i(uz), .u1_i(u1), .vx_i(vx), .vy_i(vy),
    .vz_i(vz), .v1_i(v1), .tx_i(tx), .ty_i(ty), .tz_i(tz), .t1_i(t1), .u_acc_o(u_acc), .v_acc_o(v_acc), .t_acc_o(t_acc)
  );

  // ---- Stage 3: place of a directional light; the sums wait for the offset point ----
  localparam int unsigned FINE = F - gnomon_pkg::PLACE_FRAC_BITS;
  logic signed [PLACE-1:0]  u_fine, v_fine, u_fine3_q, v_fine3_q;
  logic [D-1:0]             depth, depth3_q;
  logic                     saturated, saturated3_q;
  logic signed [D_ACC-1:0]  d_acc;
  logic signed [UV_ACC-1:0] u_acc3_q, v_acc3_q;
  logic signed [D_AS-1:0]   d_acc3_q;
  assign d_acc = D_ACC'(t_acc);  // where the third row is depth, it fits
  vpu_saturate #(.IN_BITS(UV_ACC), .SHIFT(FINE), .OUT_BITS(PLACE)) u_fine_u (.value_i(u_acc), .value_o(u_fine));
  vpu_saturate #(.IN_BITS(UV_ACC), .SHIFT(FINE), .OUT_BITS(PLACE)) u_fine_v (.value_i(v_acc), .value_o(v_fine));
  vpu_code #(.IN_BITS(D_ACC), .FRAC_BITS(gnomon_pkg::depth_frac_bits(P)), .DEPTH_BITS(D)) u_code (
    .depth_i(d_acc), .code_o(depth), .saturated_o(saturated)
  );
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      u_fine3_q    <= u_fine;
      v_fine3_q    <= v_fine;
      depth3_q     <= depth;
      saturated3_q <= saturated;
      u_acc3_q     <= u_acc;
      v_acc3_q     <= v_acc;
      d_acc3_q     <= D_AS'(d_acc >>> P);  // floor
    end
  end

  // ---- To stage TURNED: gradient of the normal; then its steps, the offset point of a directional light, the slopes ----
  logic signed [UV_ACC-1:0] u_acc_late, v_acc_late;  // in stage TURNED + 1
  logic signed [D_AS-1:0]   d_acc_late;
  logic signed [UV_S-1:0]   u_step, v_step;
  logic signed [T_S-1:0]    t_step;
  logic                     facing_away, facing_away_q, facing_away_qq;
  logic signed [PLACE-1:0]  u_moved, v_moved;        // in stage TURNED + 2, as are the next two
  logic [D-1:0]             depth_moved;
  gnomon_pkg::slopes_t      slopes;
  if (RESOLVES) begin : gen_resolve
    logic signed [UV_G-1:0] g_u, g_v;
    logic signed [T_G-1:0]  g_t;
    logic signed [F_G-1:0]  g_f;
    logic signed [T_GS-1:0] g_ts;
    vpu_gradient #(
      .POSITION_BITS(P), .NORMAL_BITS(N), .MATRIX_FRAC_BITS(F), .EN_PERSPECTIVE(EN_PERSPECTIVE), .T_M(T_M), .T_G(T_G),
      .F_G(F_G)
    ) u_gradient (
      .clk_i, .en_i, .perspective_i(perspective), .ux_i(ux), .uy_i(uy), .uz_i(uz), .vx_i(vx), .vy_i(vy), .vz_i(vz),
      .tx_i(tx), .ty_i(ty), .tz_i(tz), .light_x_i(light_x), .light_y_i(light_y), .light_z_i(light_z), .x_i(x), .y_i(y),
      .z_i(z), .nx_i(nx), .ny_i(ny), .nz_i(nz), .two_sided_i(two_sided), .g_u_o(g_u), .g_v_o(g_v),
      .g_t_o(g_t), .g_f_o(g_f), .facing_away_o(facing_away)
    );
    // Depth loses P bits here (floor), and fits; w does not.
    assign g_ts = perspective ? T_GS'(g_t) : T_GS'(g_t >>> P);
    vpu_lift #(
      .POSITION_BITS(P), .NORMAL_BITS(N), .MATRIX_FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2), .T_S(T_S)
    ) u_lift (
      .clk_i, .en_i, .factor_i(offset_factor), .g_u_i(g_u), .g_v_i(g_v), .g_t_i(g_ts), .u_step_o(u_step),
      .v_step_o(v_step), .t_step_o(t_step), .u_acc_i(u_acc_late), .v_acc_i(v_acc_late), .d_acc_i(d_acc_late),
      .u_moved_o(u_moved), .v_moved_o(v_moved), .depth_moved_o(depth_moved)
    );
    if (EN_VPU_OFFSET) begin : gen_slopes
      vpu_slopes #(.UV_G(UV_G), .F_G(F_G)) u_slopes (
        .clk_i, .en_i, .facing_shift_i(facing_shift), .tilt_shift_i(tilt_shift), .g_u_i(g_u), .g_v_i(g_v), .g_f_i(g_f),
        .slopes_o(slopes)
      );
    end else begin : gen_no_slopes
      assign slopes = '0;
      logic unused_slopes;
      assign unused_slopes = ^{g_f, facing_shift, tilt_shift};
    end
    if (EN_PERSPECTIVE && T_GS < T_G) begin : gen_narrow
      logic unused_gradient;
      assign unused_gradient = ^g_t[T_G-1:T_GS];
    end
  end else begin : gen_no_resolve
    assign facing_away = 1'b0;
    assign u_step      = '0;
    assign v_step      = '0;
    assign t_step      = '0;
    assign u_moved     = '0;
    assign v_moved     = '0;
    assign depth_moved = '0;
    assign slopes      = '0;
    logic unused_resolve;
    assign unused_resolve = ^{
      perspective, nx, ny, nz, light_x, light_y, light_z, offset_factor, facing_shift, tilt_shift, two_sided, u_acc_late,
      v_acc_late, d_acc_late
    };
  end
  always_ff @(posedge clk_i) begin
    if (en_i) begin
      facing_away_q  <= facing_away;
      facing_away_qq <= facing_away_q;
    end
  end

  if (EN_PERSPECTIVE) begin : gen_perspective
    localparam int unsigned CENTRE = PLANE_LOG2 + 2;
    logic                                          cone;
    logic signed [UV_M-1:0]                        wx, wy, wz;
    logic signed [UV_1-1:0]                        w1;
    logic [gnomon_pkg::near_bits(P)-1:0]           w_near;
    logic signed [CENTRE-1:0]                      centre_u, centre_v;
    logic [gnomon_pkg::key_bits(D)-1:0]            key_limit, key_scale;
    logic [gnomon_pkg::cone_bits(PLANE_LOG2)-1:0]  cone_squared;
    vpu_perspective_registers #(
      .POSITION_BITS(P), .MATRIX_FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2)
    ) u_registers (
      .clk_i, .rst_ni, .write_i(register_write_i), .index_i(register_index_i), .value_i(word_i), .perspective_o(perspective),
      .cone_o(cone), .wx_o(wx), .wy_o(wy), .wz_o(wz), .w1_o(w1), .w_near_o(w_near), .centre_u_o(centre_u),
      .centre_v_o(centre_v), .key_limit_o(key_limit), .key_scale_o(key_scale), .light_x_o(light_x),
      .light_y_o(light_y), .light_z_o(light_z), .cone_squared_o(cone_squared)
    );
    assign tx = perspective ? T_M'(wx) : T_M'(dx);
    assign ty = perspective ? T_M'(wy) : T_M'(dy);
    assign tz = perspective ? T_M'(wz) : T_M'(dz);
    assign t1 = perspective ? T_1'(w1) : T_1'(d1);

    // A directional light's numbers wait for those of the longer way; both come out together.
    localparam int unsigned PLACE_WAIT = 2 * PLACE + D + 1;
    localparam int unsigned MOVED_WAIT = 2 * PLACE + D;
    logic signed [PLACE-1:0] u_fine11, v_fine11, u_far, v_far, u_moved13, v_moved13, u_moved_far, v_moved_far;
    logic [D-1:0]            depth11, depth_far, depth_moved13, depth_moved_far, delta_max13;
    logic                    saturated11, saturated_far, behind, moved_behind, outside_cone;
    logic [23:0]             clearance24;
    logic signed [UV_ACC-1:0] u_acc4_q, v_acc4_q;
    logic signed [D_AS-1:0]   d_acc4_q;
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        u_acc4_q   <= u_acc3_q;
        v_acc4_q   <= v_acc3_q;
        d_acc4_q   <= d_acc3_q;
        u_acc_late <= u_acc4_q;
        v_acc_late <= v_acc4_q;
        d_acc_late <= d_acc4_q;
      end
    end
    assign clearance24 = clearance3;
    vpu_perspective #(
      .POSITION_BITS(P), .NORMAL_BITS(N), .MATRIX_FRAC_BITS(F), .DEPTH_BITS(D), .PLANE_LOG2(PLANE_LOG2)
    ) u_perspective (
      .clk_i, .rst_ni, .en_i, .cone_i(cone), .w_near_i(w_near), .centre_u_i(centre_u), .centre_v_i(centre_v),
      .key_limit_i(key_limit), .key_scale_i(key_scale), .cone_squared_i(cone_squared), .delta_max_i(delta_max_o),
      .u_acc_i(u_acc), .v_acc_i(v_acc), .w_acc_i(UV_ACC'(t_acc)), .clearance_i(beam3 ? clearance24 : 24'd0),
      .u_step_i(u_step), .v_step_i(v_step), .w_step_i(UV_S'(t_step)), .behind_o(behind), .u_fine_o(u_fine11),
      .v_fine_o(v_fine11), .depth_o(depth11), .saturated_o(saturated11), .moved_behind_o(moved_behind),
      .outside_cone_o(outside_cone), .u_moved_o(u_moved13), .v_moved_o(v_moved13), .depth_moved_o(depth_moved13),
      .delta_max_o(delta_max13)
    );
    vpu_delay #(.WIDTH(PLACE_WAIT), .CYCLES(PLACED - 3)) u_place_wait (
      .clk_i, .rst_ni, .en_i, .data_i({u_fine3_q, v_fine3_q, depth3_q, saturated3_q}),
      .data_o({u_far, v_far, depth_far, saturated_far})
    );
    vpu_delay #(.WIDTH(MOVED_WAIT), .CYCLES(MOVED - TURNED - 2)) u_moved_wait (
      .clk_i, .rst_ni, .en_i, .data_i({u_moved, v_moved, depth_moved}),
      .data_o({u_moved_far, v_moved_far, depth_moved_far})
    );
    vpu_delay #(.WIDTH(1 + gnomon_pkg::SLOPES_BITS), .CYCLES(MOVED - TURNED - 2)) u_slopes_wait (
      .clk_i, .rst_ni, .en_i, .data_i({facing_away_qq, slopes}), .data_o({facing_away_o, slopes_o})
    );
    assign behind_o         = perspective && behind;
    assign u_fine_o         = perspective ? u_fine11 : u_far;
    assign v_fine_o         = perspective ? v_fine11 : v_far;
    assign depth_o          = perspective ? depth11 : depth_far;
    assign saturated_o      = perspective ? saturated11 : saturated_far;
    assign moved_behind_o   = perspective && moved_behind;
    assign outside_cone_o   = perspective && outside_cone && !moved_behind;
    assign u_moved_o        = perspective ? u_moved13 : u_moved_far;
    assign v_moved_o        = perspective ? v_moved13 : v_moved_far;
    assign depth_moved_o    = perspective ? depth_moved13 : depth_moved_far;
    assign item_delta_max_o = (perspective && !mutations_pkg::PERSPECTIVE_PLAIN_MAX) ? delta_max13 : delta_max_o;
    assign clearance_o      = perspective ? '0 : moved_clearance[D-1:0];
    logic unused_perspective;
    assign unused_perspective = ^{t_acc, t_step, moved_clearance};
  end else begin : gen_directional
    assign perspective      = 1'b0;
    assign light_x          = '0;
    assign light_y          = '0;
    assign light_z          = '0;
    assign tx               = dx;
    assign ty               = dy;
    assign tz               = dz;
    assign t1               = d1;
    assign behind_o         = 1'b0;
    assign u_fine_o         = u_fine3_q;
    assign v_fine_o         = v_fine3_q;
    assign depth_o          = depth3_q;
    assign saturated_o      = saturated3_q;
    assign moved_behind_o   = 1'b0;
    assign outside_cone_o   = 1'b0;
    assign facing_away_o    = facing_away_qq;
    assign u_moved_o        = u_moved;
    assign v_moved_o        = v_moved;
    assign depth_moved_o    = depth_moved;
    assign slopes_o         = slopes;
    assign item_delta_max_o = delta_max_o;
    assign clearance_o      = moved_clearance;
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        u_acc_late <= u_acc3_q;
        v_acc_late <= v_acc3_q;
        d_acc_late <= d_acc3_q;
      end
    end
    logic unused_perspective;
    assign unused_perspective = ^{u_step, v_step, t_step, beam3, clearance3};
  end

endmodule
