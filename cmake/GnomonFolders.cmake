# SPDX-License-Identifier: Apache-2.0
# gnomon_add_folders(a b c): add_subdirectory for each, in the given order (dependencies first).
include_guard(GLOBAL)

function(gnomon_add_folders)
  foreach(folder IN LISTS ARGN)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt)
      add_subdirectory(${folder})
    endif()
  endforeach()
endfunction()
