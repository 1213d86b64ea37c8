// SPDX-License-Identifier: Apache-2.0
// Brings several caches to one line port: takes turns, gives out the port's ids, and leads what comes back to whom it
// belongs.

`include "assertions.svh"

module cache_port #(
  parameter int unsigned CLIENTS       = 1,
  parameter int unsigned LINE_IDS_LOG2 = 4
) (
  input  logic                               clk_i,
  input  logic                               rst_ni,
  input  logic [63:12]                       base_i,  // where line 0 lies
  input  logic [CLIENTS*cache_pkg::WANT-1:0] want_i,
  output logic [CLIENTS*cache_pkg::GIVE-1:0] give_o,
  output cache_pkg::port_want_t              port_o,
  input  cache_pkg::port_give_t              port_i
);

  localparam int unsigned WANT    = cache_pkg::WANT;
  localparam int unsigned GIVE    = cache_pkg::GIVE;
  localparam int unsigned WHO     = (CLIENTS <= 1) ? 1 : $clog2(CLIENTS);
  localparam int unsigned FILL    = cache_pkg::FILL_ID;
  localparam int unsigned VICTIM  = cache_pkg::VICTIM_ID;
  localparam int unsigned LINE    = cache_pkg::LINE;
  localparam int unsigned ID      = LINE_IDS_LOG2;
  localparam int unsigned ADDRESS = 58;

  // ---- Whose turn it is, with what id ----
  logic [CLIENTS-1:0] reads, writes;
  logic               read_take, write_take, read_free, write_free, read_room, write_room;
  logic [WHO-1:0]     reader, writer, data_owner, written_owner;
  logic [ID-1:0]      read_id, write_id, asked_id, sent_id;
  logic [FILL-1:0]    data_id;
  logic [VICTIM-1:0]  written_id;
  cache_pkg::want_t   read_want, write_want;
  assign read_want  = want_i[reader*WANT+:WANT];
  assign write_want = want_i[writer*WANT+:WANT];
  assign read_take  = reads != '0 && read_free && read_room;
  assign write_take = writes != '0 && write_free && write_room;
  cache_turn #(.CLIENTS(CLIENTS)) u_reader (.clk_i, .rst_ni, .wants_i(reads), .take_i(read_take), .who_o(reader));
  cache_turn #(.CLIENTS(CLIENTS)) u_writer (.clk_i, .rst_ni, .wants_i(writes), .take_i(write_take), .who_o(writer));
  cache_ids #(.WIDTH(WHO + FILL), .ID_BITS(ID)) u_read_ids (
    .clk_i, .rst_ni, .take_i(read_take), .data_i({reader, read_want.read_id}), .free_o(read_free), .id_o(read_id),
    .back_i(port_i.data_valid), .back_id_i(ID'(port_i.data_id)), .back_data_o({data_owner, data_id})
  );
  cache_ids #(.WIDTH(WHO + VICTIM), .ID_BITS(ID)) u_write_ids (
    .clk_i, .rst_ni, .take_i(write_take), .data_i({writer, write_want.write_id}), .free_o(write_free),
    .id_o(write_id), .back_i(port_i.written_valid), .back_id_i(ID'(port_i.written_id)),
    .back_data_o({written_owner, written_id})
  );

  // ---- To the port ----
  logic [ADDRESS-1:0] base;
  assign base = {base_i, 6'd0};
  stream_skid #(.WIDTH(ADDRESS + ID)) u_read (
    .clk_i, .rst_ni, .valid_i(reads != '0 && read_free), .ready_o(read_room),
    .data_i({base + ADDRESS'(read_want.read_line), read_id}), .valid_o(port_o.read_valid), .ready_i(port_i.read_ready),
    .data_o({port_o.read_line, asked_id})
  );
  stream_skid #(.WIDTH(ADDRESS + ID + LINE)) u_write (
    .clk_i, .rst_ni, .valid_i(writes != '0 && write_free), .ready_o(write_room),
    .data_i({base + ADDRESS'(write_want.write_line), write_id, write_want.write_data}), .valid_o(port_o.write_valid),
    .ready_i(port_i.write_ready), .data_o({port_o.write_line, sent_id, port_o.write_data})
  );
  assign port_o.read_id  = cache_pkg::LINE_ID'(asked_id);
  assign port_o.write_id = cache_pkg::LINE_ID'(sent_id);

  // ---- To the caches: flat, because Yosys knows no structure inside a generate block ----
  logic [LINE-1:0] data;
  logic            data_valid, written_valid;
  assign data          = port_i.data;
  assign data_valid    = port_i.data_valid;
  assign written_valid = port_i.written_valid;
  for (genvar i = 0; i < CLIENTS; i++) begin : gen_clients
    assign reads[i]  = want_i[i*WANT+cache_pkg::WANT_READ];
    assign writes[i] = want_i[i*WANT+cache_pkg::WANT_WRITE];
    assign give_o[i*GIVE+:GIVE] = {
      read_take && reader == WHO'(i), write_take && writer == WHO'(i), data_valid && data_owner == WHO'(i), data_id,
      written_valid && written_owner == WHO'(i), written_id, data
    };
  end
  logic unused_wants;
  assign unused_wants = ^{read_want, write_want, want_i};

  `GNOMON_ASSERT_STREAM(a_read_stable, port_o.read_valid, port_i.read_ready, {port_o.read_line, port_o.read_id})
  `GNOMON_ASSERT_STREAM(a_write_stable, port_o.write_valid, port_i.write_ready,
                        {port_o.write_line, port_o.write_id, port_o.write_data})

endmodule
