# SPDX-License-Identifier: Apache-2.0
# Every library the project uses. Package names for Debian 12 are in packages.txt.
include_guard(GLOBAL)

# gnomon_find(NAME header library): for packages whose own CMake files are missing or broken.
function(gnomon_find name header library)
  find_path(${name}_INCLUDE_DIR ${header})
  find_library(${name}_LIBRARY ${library})
  if(NOT ${name}_INCLUDE_DIR OR NOT ${name}_LIBRARY)
    message(FATAL_ERROR "${name} not found (looked for ${header} and lib${library}); packages.txt lists the Debian packages")
  endif()
  add_library(gnomon_dep_${name} INTERFACE)
  add_library(gnomon::dep::${name} ALIAS gnomon_dep_${name})
  target_include_directories(gnomon_dep_${name} SYSTEM INTERFACE ${${name}_INCLUDE_DIR})
  target_link_libraries(gnomon_dep_${name} INTERFACE ${${name}_LIBRARY})
endfunction()

function(gnomon_find_header name header)
  find_path(${name}_INCLUDE_DIR ${header})
  if(NOT ${name}_INCLUDE_DIR)
    message(FATAL_ERROR "${name} not found (looked for ${header}); packages.txt lists the Debian packages")
  endif()
  add_library(gnomon_dep_${name} INTERFACE)
  add_library(gnomon::dep::${name} ALIAS gnomon_dep_${name})
  target_include_directories(gnomon_dep_${name} SYSTEM INTERFACE ${${name}_INCLUDE_DIR})
endfunction()

find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)

# OpenSubdiv's own package file names a static library that Debian does not ship.
gnomon_find(OpenSubdiv opensubdiv/bfr/refinerSurfaceFactory.h osdCPU)
# Imath's and tl::expected's package files name files that only other Debian packages ship.
gnomon_find(Imath Imath/ImathVec.h Imath-3_1)
gnomon_find(OpenVDB openvdb/openvdb.h openvdb)
gnomon_find(Embree embree3/rtcore.h embree3)
gnomon_find(TinyObjLoader tiny_obj_loader.h tinyobjloader_double)
gnomon_find_header(TomlPlusPlus toml++/toml.h)
gnomon_find_header(Expected tl/expected.hpp)
gnomon_find_header(Boost boost/multiprecision/cpp_int.hpp)
gnomon_find(RapidCheck rapidcheck.h rapidcheck)
gnomon_find(SystemC systemc systemc)
# For tests alone: its licence is the GPL.
gnomon_find(Unicorn unicorn/unicorn.h unicorn)
gnomon_find(MuParser muParser.h muparser)
gnomon_find(Sqlite sqlite3.h sqlite3)

target_link_libraries(gnomon_dep_OpenVDB INTERFACE TBB::tbb gnomon::dep::Imath)
# libsystemc is built as C++17; its headers check the standard that they are compiled with.
target_compile_definitions(gnomon_dep_SystemC INTERFACE SC_CPLUSPLUS=201703L)
target_compile_definitions(gnomon_dep_TinyObjLoader INTERFACE TINYOBJLOADER_USE_DOUBLE)

find_program(VERILATOR_PROGRAM verilator)
if(NOT VERILATOR_PROGRAM)
  message(FATAL_ERROR "verilator not found; packages.txt lists the Debian packages")
endif()
execute_process(COMMAND ${VERILATOR_PROGRAM} --version OUTPUT_VARIABLE VERILATOR_VERSION_TEXT OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REGEX MATCH "[0-9]+\\.[0-9]+" VERILATOR_VERSION "${VERILATOR_VERSION_TEXT}")
if(NOT VERILATOR_VERSION VERSION_GREATER_EQUAL 5.006)
  message(FATAL_ERROR "Verilator ${VERILATOR_VERSION} is too old: 5.006 or newer is supported")
endif()
execute_process(COMMAND ${VERILATOR_PROGRAM} --getenv VERILATOR_ROOT OUTPUT_VARIABLE VERILATOR_ROOT OUTPUT_STRIP_TRAILING_WHITESPACE)
