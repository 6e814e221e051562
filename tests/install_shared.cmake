# SPDX-License-Identifier: MIT
# Included by install_test.cmake: the preset `install` in SHARED_BUILD, built with a shared library from the objects of BUILD,
# and its command installed and run.

# Neither GoogleTest nor Ceres may be asked for. Packages are preferred as a toolchain of Conan's would.
set(preset ${CMAKE_COMMAND} --preset install -S ${SOURCE} -B ${SHARED_BUILD} -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_FIND_PACKAGE_PREFER_CONFIG=ON -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_DISABLE_FIND_PACKAGE_Ceres=ON)
file(REMOVE_RECURSE ${SHARED_BUILD})
run(${preset})
file(READ ${SHARED_BUILD}/compile_commands.json commands)
if(NOT commands MATCHES "apps/augicp/command/main\\.cpp")
  message(FATAL_ERROR "the preset install does not build the command")
endif()
# The command's experiments use the scenes of augicp/testing, a library of its own.
foreach(unwanted _test\\.dir augicp_testing\\.dir examples/ fuzz/ -Werror)
  if(commands MATCHES "${unwanted}")
    message(FATAL_ERROR "the preset install compiles ${unwanted}: ${CMAKE_MATCH_0}")
  endif()
endforeach()

# The same sources with the same flags: Ninja takes the objects over with its log of what made them, and compiles again only
# what is not up to date or was made by another command. SHARED_BUILD lies beside BUILD: paths relative to it, which ccache
# makes of absolute ones, stay valid.
file(GLOB logs ${BUILD}/.ninja_log ${BUILD}/.ninja_deps)
file(COPY ${logs} DESTINATION ${SHARED_BUILD})
foreach(folder src apps)
  file(COPY ${BUILD}/${folder} DESTINATION ${SHARED_BUILD} FILES_MATCHING PATTERN "*_test.dir" EXCLUDE PATTERN "*.o" PATTERN "unity_*.cxx")
endforeach()
run(${preset} -DBUILD_SHARED_LIBS=ON -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  -DAUGICP_WARNINGS_AS_ERRORS=${WARNINGS_AS_ERRORS})
# The path of a file that includes several others is part of its command, so those of BUILD are compiled.
file(READ ${SHARED_BUILD}/build.ninja steps)
file(GLOB_RECURSE unities RELATIVE ${BUILD} ${BUILD}/unity_*.cxx)
foreach(unity ${unities})
  string(REPLACE "${SHARED_BUILD}/${unity}" "${BUILD}/${unity}" steps "${steps}")
endforeach()
file(WRITE ${SHARED_BUILD}/build.ninja "${steps}")
run(${CMAKE_COMMAND} --build ${SHARED_BUILD})

run(${CMAKE_COMMAND} --install ${SHARED_BUILD} --prefix ${prefix})
file(GLOB_RECURSE libraries ${prefix}/*/libaugicp.so.${VERSION})
if(NOT libraries)
  message(FATAL_ERROR "no libaugicp.so.${VERSION} below ${prefix}")
endif()
set(pair ${SOURCE}/data/room_pair)
run(${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH ${prefix}/bin/augicp align ${pair}/source.ply ${pair}/target.ply)
