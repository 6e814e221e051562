# SPDX-License-Identifier: MIT
# Installs the library into an empty prefix, then builds and runs tests/consumer against it, as a stranger would.
#   cmake -DSOURCE=... -DBUILD=... -DWORK=... -DCOMPILER=... [-DPYTHON=...]
#     [-DSHARED=ON -DSHARED_BUILD=... -DVERSION=... -DLAUNCHER=... -DWARNINGS_AS_ERRORS=...]
#     -P install_test.cmake
# Without SHARED, BUILD is installed as it is. With SHARED, the preset `install` is built in SHARED_BUILD with a shared library,
# and its command is installed too.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(cxx -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release)
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${prefix} ${WORK}/consumer)
if(SHARED)
  include(${CMAKE_CURRENT_LIST_DIR}/install_shared.cmake)
  set(BUILD ${SHARED_BUILD})
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component development)

# A public header that includes one which is not installed fails here.
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/augicp/*.h)
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
list(JOIN headers "" all_headers)
file(WRITE ${WORK}/all_headers.cpp "${all_headers}")

# Toolchains such as Conan's prefer the packages that libraries bring, some of which have targets of other names.
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${WORK}/consumer -G Ninja ${cxx} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_FIND_PACKAGE_PREFER_CONFIG=ON
  -DALL_HEADERS_SOURCE=${WORK}/all_headers.cpp -DEXAMPLES=${SOURCE}/examples)
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)
set(sample ${SOURCE}/data/tum_fr1_desk_30/depth)
file(GLOB images ${sample}/*.png)
list(GET images 0 first)
list(GET images 1 second)
run(${WORK}/consumer/example_2_align_depth_images ${second} ${first})
foreach(example 1_align_scans 3_stage_by_stage)
  run(${WORK}/consumer/example_${example} ${SOURCE}/data/room_pair/source.ply ${SOURCE}/data/room_pair/target.ply)
endforeach()

# The Python package, from the prefix alone; it was built with the library.
if(PYTHON)
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component python)
  file(GLOB_RECURSE modules ${prefix}/*/_augicp*.so)
  list(LENGTH modules count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "expected one Python module below ${prefix}, found: ${modules}")
  endif()
  cmake_path(GET modules PARENT_PATH package)
  cmake_path(GET package PARENT_PATH site)
  run(${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH PYTHONPATH=${site} ${PYTHON} ${SOURCE}/tests/install_python.py
    ${prefix})
endif()
