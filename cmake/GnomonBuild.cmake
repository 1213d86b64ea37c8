# SPDX-License-Identifier: Apache-2.0
# Language level, warnings, build type, sanitizers, coverage and compiler cache, the same for every folder.
include_guard(GLOBAL)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

option(GNOMON_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(GNOMON_COVERAGE "Instrument for gcov" OFF)
option(GNOMON_TIDY "Run clang-tidy on every translation unit" OFF)
option(GNOMON_UNITY "Compile several sources at once" OFF)

# For folders whose sources are compiled several at once where that is asked for: most of a compiler's work is on their headers
# (docs/building.md). The calling folder and those below; gnomon_compile_alone(sources...): but for these, whose names in unnamed
# namespaces others have too.
macro(gnomon_compile_together)
  set(CMAKE_UNITY_BUILD ${GNOMON_UNITY})
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endmacro()
function(gnomon_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Link this to every target of our own: warnings are errors, the instrumentation follows the preset.
add_library(gnomon_build INTERFACE)
add_library(gnomon::build ALIAS gnomon_build)
target_compile_options(gnomon_build INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wnon-virtual-dtor -Werror)
if(GNOMON_UNITY)
  # A member whose type is in an unnamed namespace: meant for headers, seen wherever a source is included.
  target_compile_options(gnomon_build INTERFACE -Wno-subobject-linkage)
endif()
# No fused multiply-add behind our back: results must not depend on the optimiser's choices.
target_compile_options(gnomon_build INTERFACE -ffp-contract=off)
if(GNOMON_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  # Still shown, but no error: the library's <regex>, once instrumented, sets it off in GCC 12.
  target_compile_options(gnomon_build INTERFACE -Wno-error=maybe-uninitialized)
endif()
if(GNOMON_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()
if(GNOMON_TIDY)
  find_program(CLANG_TIDY_PROGRAM clang-tidy REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${CLANG_TIDY_PROGRAM} --quiet)
endif()

# For folders whose code is compiled more often than it runs long, plumbing and tests: the calling folder and those below are
# compiled at -O1, which takes two thirds of the time.
macro(gnomon_compile_quickly)
  string(REPLACE "-O3" "-O1" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
endmacro()
