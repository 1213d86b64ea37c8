# SPDX-License-Identifier: Apache-2.0
# Turns the files ASSETS of FOLDER into the C++ source OUTPUT; page_assets.hpp declares what it defines.
set(source "// Made by embed_assets.cmake.\n#include \"host/report/page_assets.hpp\"\n\nnamespace gnomon::report {\n")
foreach(asset IN LISTS ASSETS)
  # Bytes as hexadecimal: no character needs escaping, no literal grows too long.
  file(READ ${FOLDER}/${asset} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "^report\\." "" name "${asset}")
  string(REGEX REPLACE "\\.mustache$" "" name "${name}")
  string(APPEND source "namespace {\nconstexpr char k_${name}[] = {${bytes}};\n}\n"
         "std::string_view page_${name}() { return {k_${name}, sizeof(k_${name})}; }\n")
endforeach()
string(APPEND source "}  // namespace gnomon::report\n")
file(WRITE ${OUTPUT} "${source}")
