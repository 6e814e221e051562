# SPDX-License-Identifier: MIT
# cmake -DFIRST=program -DSECOND=program -P same_bits_test.cmake: fails unless both print the same.
foreach(which FIRST SECOND)
  execute_process(COMMAND ${${which}} OUTPUT_VARIABLE ${which}_text COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT FIRST_text STREQUAL SECOND_text)
  message(FATAL_ERROR "${FIRST} prints\n${FIRST_text}\n${SECOND} prints\n${SECOND_text}")
endif()
