gnomon_top.sv
