# SPDX-License-Identifier: MIT
# One call per module: its sources, public headers, tests and the modules it may include.
#
# Modules are object libraries. CMake refuses cycles among them, and the library users link, augicp::augicp, is made of their
# objects. A module that is NOT_INSTALLED is a library of its own instead, augicp_NAME_library, for the command and the tests. `tests/includes_test.py` checks that a module includes only what its DEPENDS names.

add_library(augicp_build_flags INTERFACE)
target_compile_features(augicp_build_flags INTERFACE cxx_std_20)
target_compile_options(augicp_build_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
  # GCC 12 warns of overlapping copies inside its own std::string (GCC bug 105651). clang-tidy, which reads these options
  # too, does not know that warning.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-unknown-warning-option;-Wno-restrict>
  $<$<BOOL:${AUGICP_WARNINGS_AS_ERRORS}>:-Werror>
  # Bit-identical results everywhere: the compiler may not fuse a multiplication and an addition in one build and not in another.
  -ffp-contract=off
  # Nothing reads errno or the flags of floating-point exceptions. Without them loops with roots and choices vectorise, with
  # bit-identical results.
  -fno-math-errno -fno-trapping-math)
if(AUGICP_SANITIZE)
  target_compile_options(augicp_build_flags INTERFACE -fsanitize=${AUGICP_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_definitions(augicp_build_flags INTERFACE AUGICP_SANITIZED)  # see testing/repeats.h
  if(AUGICP_SANITIZE MATCHES address AND AUGICP_SANITIZE MATCHES undefined)
    # Accesses beyond an object: on the heap, the stack and in globals the address sanitizer finds them too.
    target_compile_options(augicp_build_flags INTERFACE -fno-sanitize=object-size)
    # Checks make Eigen's small functions too long for the compiler's limit of inlining: each access of a matrix would be a chain of calls.
    target_compile_definitions(augicp_build_flags INTERFACE "EIGEN_STRONG_INLINE=inline __attribute__((always_inline))")
  endif()
  target_link_options(augicp_build_flags INTERFACE -fsanitize=${AUGICP_SANITIZE})
endif()

if(AUGICP_BUILD_FUZZERS)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "AUGICP_BUILD_FUZZERS needs clang, found ${CMAKE_CXX_COMPILER_ID}")
  endif()
  # Input of libFuzzer: the branches that an input reached.
  target_compile_options(augicp_build_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

include(AugicpPrecompiled)
include(AugicpUnity)

function(augicp_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NOT_INSTALLED" "" "HEADERS;SOURCES;TESTS;DEPENDS;PRIVATE")
  add_library(augicp_${name} OBJECT)
  list(TRANSFORM arg_SOURCES PREPEND ${name}/)
  list(TRANSFORM arg_HEADERS PREPEND ${name}/)
  target_sources(augicp_${name} PRIVATE ${arg_SOURCES} ${arg_HEADERS})
  set_target_properties(augicp_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON LINKER_LANGUAGE CXX)
  list(TRANSFORM arg_DEPENDS PREPEND augicp_)
  target_link_libraries(augicp_${name} PUBLIC Eigen3::Eigen ${arg_DEPENDS} PRIVATE augicp_build_flags ${arg_PRIVATE})
  target_include_directories(augicp_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  # The definitions of its private libraries are flags of its own.
  set(kind library)
  if(arg_PRIVATE)
    set(kind ${name})
  endif()
  augicp_precompile(augicp_${name} ${kind} ${AUGICP_LIBRARY_HEADERS})
  augicp_unity(augicp_${name})
  if(arg_NOT_INSTALLED)
    add_library(augicp_${name}_library STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:augicp_${name}>)
    set_target_properties(augicp_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    target_link_libraries(augicp_${name}_library PUBLIC augicp ${arg_PRIVATE})
  else()
    set_property(GLOBAL APPEND PROPERTY AUGICP_MODULES ${name})
    set_property(GLOBAL APPEND PROPERTY AUGICP_PRIVATE_LIBRARIES ${arg_PRIVATE})
  endif()
  if(arg_TESTS)
    set_property(GLOBAL APPEND PROPERTY AUGICP_TESTED_MODULES ${name})
    set_property(GLOBAL PROPERTY AUGICP_TESTS_${name} ${arg_TESTS})
  endif()
endfunction()

# Sets result to those of the test files under ${name}/ that are built. Under the thread sanitizer these are the ones with a test
# named for threads: it slows everything down, and finds something only where there are threads.
function(augicp_built_tests result name)
  list(TRANSFORM ARGN PREPEND ${name}/ OUTPUT_VARIABLE tests)
  if(AUGICP_SANITIZE MATCHES thread)
    set(threaded "")
    foreach(test IN LISTS tests)
      file(STRINGS ${test} found REGEX "TEST.*(Thread|Parallel|Concurrent)")
      if(found OR test MATCHES "\\.h$")
        list(APPEND threaded ${test})
      endif()
    endforeach()
    set(tests ${threaded})
  endif()
  set(${result} ${tests} PARENT_SCOPE)
endfunction()

# The unit tests of one module, made after the library so that they may use all of it and the testing module.
function(augicp_module_tests name)
  get_property(tests GLOBAL PROPERTY AUGICP_TESTS_${name})
  augicp_built_tests(tests ${name} ${tests})
  if(NOT tests MATCHES "\\.cpp")
    return()
  endif()
  add_executable(augicp_${name}_test ${tests})
  # What is tested is the library. At the level of its own code a file of tests takes half as long again to compile.
  target_compile_options(augicp_${name}_test PRIVATE $<$<CONFIG:Release>:-O1>)
  add_dependencies(augicp_unit_tests augicp_${name}_test)
  target_link_libraries(augicp_${name}_test PRIVATE augicp_synthetic augicp_testing augicp_build_flags GTest::gmock_main ${ARGN})
  set(kind test)
  if(ARGN)
    set(kind test_of_${name})
  endif()
  augicp_precompile(augicp_${name}_test ${kind} ${AUGICP_TEST_HEADERS})
  augicp_unity(augicp_${name}_test)
  gtest_discover_tests(augicp_${name}_test TEST_PREFIX "${name}: " NO_PRETTY_VALUES DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT 300 ${AUGICP_DECIMAL_COMMA})
endfunction()
