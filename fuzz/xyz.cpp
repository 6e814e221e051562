// SPDX-License-Identifier: MIT
// One reader serves .xyz, .txt, .csv and .pts.
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  augicp::fuzz::check_cloud_reader("any.csv", data, size);
  return 0;
}
