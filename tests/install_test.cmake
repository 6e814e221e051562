# SPDX-License-Identifier: MIT
# Installs the library into an empty prefix, then builds and runs tests/consumer against it, as a stranger would.
#   cmake -DSOURCE=... -DBUILD=... -DWORK=... -DCOMPILER=... [-DSHARED=ON -DWARNINGS_AS_ERRORS=...] [-DPYTHON=...] -P install_test.cmake
# With SHARED the library is first built as a shared one in WORK/build, without the Python module; otherwise BUILD is installed as it is.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(cxx -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release)
if(SHARED)
  # The same sources with the same flags: Ninja takes the objects over with its log of what made them, and compiles again only
  # what is not up to date or was made by another command.
  file(REMOVE_RECURSE ${WORK}/build)
  file(GLOB logs ${BUILD}/.ninja_log ${BUILD}/.ninja_deps)
  file(COPY ${logs} DESTINATION ${WORK}/build)
  file(COPY ${BUILD}/src DESTINATION ${WORK}/build FILES_MATCHING PATTERN "*_test.dir" EXCLUDE PATTERN "*.o")
  set(BUILD ${WORK}/build)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja ${cxx} -DBUILD_SHARED_LIBS=ON -DAUGICP_WARNINGS_AS_ERRORS=${WARNINGS_AS_ERRORS}
    -DAUGICP_BUILD_TESTS=OFF -DAUGICP_BUILD_APPS=OFF -DAUGICP_BUILD_EXAMPLES=OFF -DAUGICP_BUILD_PYTHON=OFF)
  run(${CMAKE_COMMAND} --build ${BUILD} --target augicp)
endif()

set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${prefix} ${WORK}/consumer)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component development)

# A public header that includes one which is not installed fails here.
file(GLOB_RECURSE headers RELATIVE ${prefix}/include ${prefix}/include/augicp/*.h)
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
list(JOIN headers "" all_headers)
file(WRITE ${WORK}/all_headers.cpp "${all_headers}")

run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${WORK}/consumer -G Ninja ${cxx} -DCMAKE_PREFIX_PATH=${prefix}
  -DALL_HEADERS_SOURCE=${WORK}/all_headers.cpp)
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)

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
