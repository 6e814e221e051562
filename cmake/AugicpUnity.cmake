# SPDX-License-Identifier: MIT
# Files of a target compiled together, eight as one: headers are read once, and templates compiled once, for all of them. A name in an
# unnamed namespace then belongs to all of them, and must be there once. The compiler sees most second ones; a function with other
# parameters is an overload, so the optimised preset compiles each file alone. Packages and wheels take over its objects, too.
option(AUGICP_UNITY "Compile several files of a target as one" OFF)

function(augicp_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${AUGICP_UNITY} UNITY_BUILD_BATCH_SIZE 8)
endfunction()
