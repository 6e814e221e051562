# SPDX-License-Identifier: MIT
# Precompiled headers: half of the time of compiling a small file goes into Eigen's, GoogleTest's and the standard
# library's. They hide includes that a file forgets, so scripts/test builds the optimised preset without them.
option(AUGICP_PRECOMPILE_HEADERS "Compile the headers that most files include once" OFF)

# augicp_precompile(TARGET KIND HEADERS...): targets of one kind have the same flags, and use what the first one made.
function(augicp_precompile target kind)
  if(NOT AUGICP_PRECOMPILE_HEADERS)
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
