# SPDX-License-Identifier: Apache-2.0
# cmake -D IMAGE=gnomon.bin -D TEMPLATE=image.cpp.in -D OUTPUT=image.cpp -P embed.cmake: the image as C++.
file(READ ${IMAGE} digits HEX)
string(LENGTH "${digits}" SIZE)
math(EXPR SIZE "${SIZE} / 2")
string(REGEX REPLACE "(..)" "0x\\1," BYTES "${digits}")
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
