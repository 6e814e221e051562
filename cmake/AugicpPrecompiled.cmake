# SPDX-License-Identifier: MIT
# Precompiled headers: half of the time of compiling a small file goes into Eigen's, GoogleTest's and the standard library's.
# They hide includes that a file forgets, so the library is built without them at least once in scripts/test.
set(AUGICP_PRECOMPILE_HEADERS "" CACHE STRING "Precompiled headers: empty for none, `tests` for the tests' own, or `all`")
set_property(CACHE AUGICP_PRECOMPILE_HEADERS PROPERTY STRINGS "" tests all)

# The first target that is named compiles the headers; later ones with the same flags use what it made.
function(augicp_precompile_library target)
  if(AUGICP_PRECOMPILE_HEADERS STREQUAL all)
    augicp_precompile(${target} AUGICP_LIBRARY_HEADERS <Eigen/Dense> <algorithm> <functional> <span> <string> <vector>)
  endif()
endfunction()

function(augicp_precompile_tests target)
  if(AUGICP_PRECOMPILE_HEADERS)
    augicp_precompile(${target} AUGICP_TEST_HEADERS <Eigen/Dense> <algorithm> <functional> <string> <vector> <gmock/gmock.h> <gtest/gtest.h>)
  endif()
endfunction()

# augicp_precompile(TARGET PROPERTY HEADERS...): PROPERTY keeps the name of the first target.
function(augicp_precompile target property)
  get_property(first GLOBAL PROPERTY ${property})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY ${property} ${target})
  endif()
endfunction()
