# SPDX-License-Identifier: MIT
# AUGICP_BUILD_PYTHON: whether the Python module is built, on where its packages are. AUGICP_PYTHON: the interpreter, also
# of the tests. AUGICP_PYTHON_SITE: where packages are installed, below the prefix.

# The system's own Python first: one that a version manager puts before it may lack the system's packages. What builds a
# wheel says which one it is for.
if(DEFINED Python3_EXECUTABLE)
  set(AUGICP_PYTHON ${Python3_EXECUTABLE} CACHE FILEPATH "Python")
endif()
find_program(AUGICP_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(AUGICP_PYTHON python3)

set(missing "")
if(AUGICP_SANITIZE)
  set(missing "it cannot be loaded into a Python without the sanitizers")
elseif(NOT AUGICP_PYTHON)
  set(missing "no Python 3 was found")
else()
  set(Python3_EXECUTABLE ${AUGICP_PYTHON})
  # Only running the module needs NumPy. Where the module is run from the build, its absence should be told at once.
  set(augicp_numpy NumPy)
  if(SKBUILD)
    set(augicp_numpy "")
  endif()
  find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module ${augicp_numpy})
  find_package(pybind11 2.10 QUIET CONFIG)
  if(NOT Python3_FOUND)
    set(missing "${AUGICP_PYTHON} lacks its headers or NumPy (python3-dev, python3-numpy)")
  elseif(NOT pybind11_FOUND)
    set(missing "pybind11 was not found (pybind11-dev)")
  endif()
endif()

if(missing)
  set(is_possible OFF)
else()
  set(is_possible ${PROJECT_IS_TOP_LEVEL})
endif()
option(AUGICP_BUILD_PYTHON "Build the Python module" ${is_possible})
if(AUGICP_BUILD_PYTHON AND missing)
  message(FATAL_ERROR "AUGICP_BUILD_PYTHON is on, but ${missing}")
elseif(missing)
  message(STATUS "The Python module is not built: ${missing}")
elseif(AUGICP_BUILD_PYTHON)
  # Debian's own directory is dist-packages, elsewhere it is site-packages.
  execute_process(COMMAND ${AUGICP_PYTHON} -c
    "import os, sys, sysconfig; print('lib/python%d.%d/' % sys.version_info[:2] + os.path.basename(sysconfig.get_path('platlib')))"
    OUTPUT_VARIABLE site OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(AUGICP_PYTHON_SITE ${site} CACHE STRING "Where the Python package is installed, below the prefix")
  message(STATUS "The Python module is built for ${AUGICP_PYTHON}")
endif()
