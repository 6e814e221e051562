# SPDX-License-Identifier: MIT
# Libraries of Debian 12 in place of packages of Conan:
#   conan create packaging/conan --profile:all packaging/conan/debian.profile
include(default)
[settings]
compiler.cppstd=gnu20
[platform_requires]
bzip2/1.0.8
eigen/3.4.0
fmt/9.1.0
libspng/0.7.3
lz4/1.9.4
lzf/3.6
nlohmann_json/3.11.2
onetbb/2021.8.0
sqlite3/3.40.1
zlib/1.2.13
zstd/1.5.4
