// SPDX-License-Identifier: MIT
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  augicp::fuzz::check_cloud_reader("any.gltf", data, size);
  return 0;
}
