gnomon_core.sv
