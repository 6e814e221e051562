# SPDX-License-Identifier: MIT
# Toolchain for 64-bit ARM with Debian's cross compiler. AUGICP_SYSROOT, in the environment too: a folder with Debian's packages for
# arm64. Tests run in qemu's emulator. Used by scripts/portability.
if(NOT AUGICP_SYSROOT)
  set(AUGICP_SYSROOT $ENV{AUGICP_SYSROOT})
endif()
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES AUGICP_SYSROOT)

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_SYSROOT ${AUGICP_SYSROOT})
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${AUGICP_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
# Packages that only pkg-config knows.
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${AUGICP_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${AUGICP_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${AUGICP_SYSROOT}/usr/share/pkgconfig)
