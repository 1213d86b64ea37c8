# SPDX-License-Identifier: Apache-2.0
# Turns the files ASSETS of FOLDER into the C++ source OUTPUT. HEADER declares what it defines in NAMESPACE: for
# "report.css" page_css(), for "uplot/uPlot.min.css" page_uPlot_min_css().
set(source "// Made by embed_assets.cmake.\n#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(asset IN LISTS ASSETS)
  # Bytes as hexadecimal: no character needs escaping, no literal grows too long.
  file(READ ${FOLDER}/${asset} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "^.*/" "" name "${asset}")
  string(REGEX REPLACE "^(report|sweep)\\." "" name "${name}")
  string(REGEX REPLACE "\\.mustache$" "" name "${name}")
  string(REPLACE "." "_" name "${name}")
  string(APPEND source "namespace {\nconstexpr char k_${name}[] = {${bytes}};\n}\n"
         "std::string_view page_${name}() { return {k_${name}, sizeof(k_${name})}; }\n")
endforeach()
string(APPEND source "}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT} "${source}")
