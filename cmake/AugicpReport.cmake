# SPDX-License-Identifier: MIT
# The script of the reports: bundled by esbuild where Node and the packages of apps/augicp/page/web/package.json are there
# (scripts/build-report brings them). Else the bundle of a source distribution is taken (scripts/build-report --bundle made it), else
# it is left out: reports then have curves and tables, and no 3D views. Nothing is downloaded here.

option(AUGICP_REPORT_SCRIPT "Bundle the script of the reports, where Node and its packages are there" ON)
set(AUGICP_WEB ${PROJECT_SOURCE_DIR}/apps/augicp/page/web)

find_program(AUGICP_NODE NAMES node nodejs)
set(AUGICP_NODE_VERSION 0)
if(AUGICP_NODE)
  execute_process(COMMAND ${AUGICP_NODE} --version OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  string(REGEX REPLACE "^v([0-9]+).*" "\\1" AUGICP_NODE_VERSION "${output}")
endif()
set(AUGICP_READY_BUNDLE ${PROJECT_SOURCE_DIR}/packaging/report/report.js)
set(AUGICP_CAN_BUNDLE OFF)
if(AUGICP_REPORT_SCRIPT AND AUGICP_NODE_VERSION GREATER_EQUAL 18 AND EXISTS ${AUGICP_WEB}/node_modules/esbuild
   AND EXISTS ${AUGICP_WEB}/node_modules/three AND EXISTS ${AUGICP_WEB}/node_modules/uplot)
  set(AUGICP_CAN_BUNDLE ON)
elseif(AUGICP_REPORT_SCRIPT AND NOT EXISTS ${AUGICP_READY_BUNDLE})
  message(STATUS "Reports without 3D views: needs Node 18 or newer, and scripts/build-report")
endif()

# augicp_report_bundle(FILE [SCRIPT]): a source file that defines report_bundle(), with the script or without.
function(augicp_report_bundle file)
  set(script "")
  if("SCRIPT" IN_LIST ARGN AND AUGICP_CAN_BUNDLE)
    set(script ${CMAKE_CURRENT_BINARY_DIR}/report.js)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${AUGICP_WEB}/src/*.ts)
    add_custom_command(OUTPUT ${script} ${script}.sha256
      COMMAND ${AUGICP_NODE} bundle.mjs ${CMAKE_CURRENT_BINARY_DIR}
      DEPENDS ${sources} ${AUGICP_WEB}/bundle.mjs ${AUGICP_WEB}/package-lock.json
      WORKING_DIRECTORY ${AUGICP_WEB} COMMENT "Bundling the reports' script" VERBATIM)
  elseif("SCRIPT" IN_LIST ARGN AND AUGICP_REPORT_SCRIPT AND EXISTS ${AUGICP_READY_BUNDLE})
    set(script ${AUGICP_READY_BUNDLE})
  endif()
  set(embed ${PROJECT_SOURCE_DIR}/cmake/embed_report.cmake)
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -DSTYLE=${AUGICP_WEB}/style.css -DSCRIPT=${script} -DOUTPUT=${file} -P ${embed}
    DEPENDS ${AUGICP_WEB}/style.css ${script} ${embed} VERBATIM)
endfunction()
