# SPDX-License-Identifier: MIT
# Files of a target compiled together, eight as one: headers are read once, and templates compiled once, for all of them. A name in an
# unnamed namespace then belongs to all of them, and must be there once. The compiler sees most second ones; a function with other
# parameters is an overload. So the optimised preset compiles each file of the library and of the command alone, as packages and
# wheels do, which take over its objects. There the files of tests alone are put together.
set(AUGICP_UNITY OFF CACHE STRING "Compile several files of a target as one: OFF, TESTS (of test files) or ON")
set_property(CACHE AUGICP_UNITY PROPERTY STRINGS OFF TESTS ON)

# augicp_unity(TARGET [TEST])
function(augicp_unity target)
  if(AUGICP_UNITY STREQUAL "TESTS" AND NOT "TEST" IN_LIST ARGN OR NOT AUGICP_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
endfunction()
