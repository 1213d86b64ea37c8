// SPDX-License-Identifier: Apache-2.0
// Source files of topology mode in reading order, relative to this file; they build on those of ../gnomon.f.
topology_pkg.sv
topology_corner.sv
topology_quad.sv
topology_linker.sv
topology_link.sv
topology_put.sv
topology_heads.sv
topology_store.sv
topology_lift.sv
topology_hit.sv
topology_walker.sv
topology_order.sv
topology_resolve.sv
topology_reader.sv
topology.sv
