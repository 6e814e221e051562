# SPDX-License-Identifier: MIT
# Files of a target compiled together, eight as one: headers are read once, and templates compiled once, for all of them. A name in an
# unnamed namespace then belongs to all files of a target, and must be there once. An include that a file forgets is found by the
# preset `tidy`, which compiles each file alone.
option(AUGICP_UNITY "Compile eight files of a target as one" OFF)

function(augicp_unity target)
  if(AUGICP_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
