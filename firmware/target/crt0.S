# SPDX-License-Identifier: Apache-2.0
# Start: stack, trap vector, zeroes in .bss, main. The image is loaded as it is, so .data is in place already.
  .section .init, "ax"
  .globl _start
_start:
  la sp, __stack_top
  la t0, trap_handler
  csrw mtvec, t0
  la t0, __bss_start
  la t1, __bss_end
clear:
  beq t0, t1, run
  sw zero, 0(t0)
  addi t0, t0, 4
  j clear
run:
  call main
stop:
  wfi
  j stop
