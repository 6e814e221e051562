// SPDX-License-Identifier: MIT
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  augicp::ReadOptions options;
  options.sample_faces = true;
  augicp::fuzz::check_cloud_reader("any.ply", data, size, options);
  return 0;
}
