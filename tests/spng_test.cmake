# SPDX-License-Identifier: MIT
# cmake/Findspng.cmake prefers libspng's own package, in each kind it may have, to pkg-config, and says what it looked for.
#   cmake -DSOURCE=... -DWORK=... -DCOMPILER=... -P spng_test.cmake
cmake_minimum_required(VERSION 3.22)

# expect(NAME REGEX [OPTIONS...]): what the output of a configuration with these options must match.
function(expect name regex)
  file(REMOVE_RECURSE ${WORK}/${name})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/tests/spng -B ${WORK}/${name} -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_MODULE_PATH=${SOURCE}/cmake ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT output MATCHES "${regex}")
    message(FATAL_ERROR "${name}: no ${regex} in\n${output}")
  endif()
endfunction()

# with_package(NAME TARGET): a prefix with a package as libspng's build writes it, and one kind of library in it.
function(with_package name target)
  file(WRITE ${WORK}/prefix_${name}/lib/cmake/spng/SPNGConfig.cmake
    "add_library(${target} INTERFACE IMPORTED)\nset_target_properties(${target} PROPERTIES INTERFACE_LINK_LIBRARIES of_${name})\n")
endfunction()

with_package(shared spng::spng)
with_package(static spng::spng_static)
expect(shared "spng::spng links of_shared" -DCMAKE_PREFIX_PATH=${WORK}/prefix_shared)
expect(static "spng::spng links spng::spng_static" -DCMAKE_PREFIX_PATH=${WORK}/prefix_static)
expect(pkg_config "spng::spng links PkgConfig::spng" -DCMAKE_DISABLE_FIND_PACKAGE_SPNG=ON)
expect(nothing "neither SPNGConfig.cmake nor" -DCMAKE_DISABLE_FIND_PACKAGE_SPNG=ON -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)
