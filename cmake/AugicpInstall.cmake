# SPDX-License-Identifier: MIT
# Installs the library, its public headers and a package, so that find_package(augicp) gives augicp::augicp.
include(CMakePackageConfigHelpers)

set(AUGICP_INSTALL_CMAKEDIR ${CMAKE_INSTALL_LIBDIR}/cmake/augicp)

# The lines with which a package file finds these imported targets: Package::target comes from find_package(Package). So a
# module that links something new needs no change here. What cmake/ finds by a file of its own is found by that file, whatever
# the toolchain prefers.
function(augicp_find_lines result)
  set(lines "")
  foreach(library IN LISTS ARGN)
    if(library MATCHES "^(.+)::")
      string(REGEX REPLACE "^SQLite$" "SQLite3" package "${CMAKE_MATCH_1}")  # the one whose name differs
      set(mode "")
      if(EXISTS ${PROJECT_SOURCE_DIR}/cmake/Find${package}.cmake)
        set(mode " MODULE")
      endif()
      string(APPEND lines "find_dependency(${package}${mode})\n")
    endif()
  endforeach()
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

set(AUGICP_FIND_PRIVATE_LIBRARIES "")
get_target_property(augicp_type augicp TYPE)
if(augicp_type STREQUAL "STATIC_LIBRARY")
  get_property(augicp_private_libraries GLOBAL PROPERTY AUGICP_PRIVATE_LIBRARIES)
  list(REMOVE_DUPLICATES augicp_private_libraries)
  augicp_find_lines(AUGICP_FIND_PRIVATE_LIBRARIES ${augicp_private_libraries})
  install(FILES cmake/Findlz4.cmake cmake/Findspng.cmake cmake/Findzstd.cmake DESTINATION ${AUGICP_INSTALL_CMAKEDIR} COMPONENT development)
endif()

configure_package_config_file(cmake/augicpConfig.cmake.in ${PROJECT_BINARY_DIR}/augicpConfig.cmake
  INSTALL_DESTINATION ${AUGICP_INSTALL_CMAKEDIR})
# Below 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/augicpConfigVersion.cmake COMPATIBILITY SameMinorVersion)

# A component of its own: a package of the library needs no command, and the test of it no complete build.
install(TARGETS augicp EXPORT augicpTargets COMPONENT development)
install(EXPORT augicpTargets NAMESPACE augicp:: DESTINATION ${AUGICP_INSTALL_CMAKEDIR} COMPONENT development)
install(FILES ${PROJECT_BINARY_DIR}/augicpConfig.cmake ${PROJECT_BINARY_DIR}/augicpConfigVersion.cmake
  DESTINATION ${AUGICP_INSTALL_CMAKEDIR} COMPONENT development)

# The public headers: augicp/augicp.h and what it includes, directly or not, relative to src/.
function(augicp_public_headers result)
  set(found "")
  set(todo augicp/augicp.h)
  while(todo)
    list(POP_FRONT todo header)
    if(NOT header IN_LIST found)
      list(APPEND found ${header})
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${header})
      file(STRINGS ${PROJECT_SOURCE_DIR}/src/${header} lines REGEX "^#include \"augicp/")
      list(TRANSFORM lines REPLACE "^#include \"([^\"]+)\".*" "\\1")
      list(APPEND todo ${lines})
    endif()
  endwhile()
  set(${result} ${found} PARENT_SCOPE)
endfunction()

augicp_public_headers(augicp_headers)
foreach(header IN LISTS augicp_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES src/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder} COMPONENT development)
endforeach()
