# SPDX-License-Identifier: MIT
# Precompiled headers: half of the time of compiling a small file goes into Eigen's, GoogleTest's and the standard
# library's. They hide includes that a file forgets, so the optimised preset precompiles those of the tests alone. With GCC 12 and full
# optimisation, warnings inside the standard library's own headers would no longer be suppressed there.
set(AUGICP_PRECOMPILE_HEADERS OFF CACHE STRING "Compile once the headers that most files include: OFF, TESTS (of test files) or ON")
set_property(CACHE AUGICP_PRECOMPILE_HEADERS PROPERTY STRINGS OFF TESTS ON)

# augicp_precompile(TARGET KIND HEADERS...): targets of one kind have the same flags, and use what the first one made. The kinds
# of test files begin with "test".
function(augicp_precompile target kind)
  if(NOT AUGICP_PRECOMPILE_HEADERS OR (AUGICP_PRECOMPILE_HEADERS STREQUAL "TESTS" AND NOT kind MATCHES "^test"))
    return()
  endif()
  get_property(first GLOBAL PROPERTY AUGICP_PRECOMPILED_${kind})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${ARGN})
    set_property(GLOBAL PROPERTY AUGICP_PRECOMPILED_${kind} ${target})
  endif()
endfunction()

set(AUGICP_LIBRARY_HEADERS <Eigen/Dense> <algorithm> <functional> <span> <string> <vector>)
set(AUGICP_TEST_HEADERS <Eigen/Dense> <algorithm> <functional> <string> <vector> <gmock/gmock.h> <gtest/gtest.h>)
