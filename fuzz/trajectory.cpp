// SPDX-License-Identifier: MIT
#include "augicp/io/trajectory_file.h"
#include "fuzz/promises.h"

using namespace augicp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.txt", data, size);
  fuzz::expect_read_or_refused(file.path, [&] { fuzz::expect_sound(parse_tum_trajectory(file).trajectory); });
  return 0;
}
