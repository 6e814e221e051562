# SPDX-License-Identifier: MIT
# A locale with a decimal comma, made below the build folder, for tests that hold that numbers do not depend on the locale. A machine
# need not have one installed; where the definitions (Debian's package locales) are missing too, those tests are skipped.

# Sets result to the test property that lets tests find the locale, or to nothing.
function(augicp_decimal_comma result)
  set(${result} "" PARENT_SCOPE)
  set(folder ${PROJECT_BINARY_DIR}/locale)
  if(NOT EXISTS ${folder}/de_DE.UTF-8/LC_NUMERIC)
    find_program(AUGICP_LOCALEDEF localedef)
    if(NOT AUGICP_LOCALEDEF)
      return()
    endif()
    file(MAKE_DIRECTORY ${folder})
    execute_process(COMMAND ${AUGICP_LOCALEDEF} --no-archive -i de_DE -f UTF-8 ${folder}/de_DE.UTF-8 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(failed)
      file(REMOVE_RECURSE ${folder})
      return()
    endif()
  endif()
  set(${result} ENVIRONMENT LOCPATH=${folder} PARENT_SCOPE)
endfunction()
