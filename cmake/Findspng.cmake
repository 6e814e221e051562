# SPDX-License-Identifier: MIT
# spng::spng, the PNG library: by the package files that libspng's own build installs (SPNG), and where there are none, as in
# Debian's package, by pkg-config. The package of a static augicp has this file too.
find_package(SPNG CONFIG QUIET)
if(NOT SPNG_FOUND)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(spng QUIET IMPORTED_TARGET spng)
  endif()
endif()

if(NOT TARGET spng::spng)
  # libspng's package has a target for each kind of library that was built.
  foreach(spng_kind spng::spng_static PkgConfig::spng)
    if(TARGET ${spng_kind})
      add_library(spng::spng INTERFACE IMPORTED)
      set_target_properties(spng::spng PROPERTIES INTERFACE_LINK_LIBRARIES ${spng_kind})
      break()
    endif()
  endforeach()
endif()
set(spng_target "")
if(TARGET spng::spng)
  set(spng_target spng::spng)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(spng REQUIRED_VARS spng_target
  REASON_FAILURE_MESSAGE "neither SPNGConfig.cmake nor pkg-config's spng (libspng-dev) was found")
