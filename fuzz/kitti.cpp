// SPDX-License-Identifier: MIT
// The file does not say how many numbers a point has: all are tried.
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const int num_columns : {0, 3, 4, 5, 6}) {
    augicp::ReadOptions options;
    options.num_bin_columns = num_columns;
    augicp::fuzz::check_cloud_reader("any.bin", data, size, options);
  }
  return 0;
}
