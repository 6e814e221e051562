// SPDX-License-Identifier: MIT
// Poses in any of the usual forms.
#include "augicp/io/pose_file.h"
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const augicp::FileBytes file = augicp::fuzz::file_of("any.csv", data, size);
  augicp::fuzz::expect_read_or_refused(
      file.path, [&] { augicp::fuzz::expect_sound(augicp::parse_poses(file).content.trajectory); });
  return 0;
}
