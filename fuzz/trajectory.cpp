// SPDX-License-Identifier: MIT
#include "augicp/io/pose_file.h"
#include "augicp/io/reference_pairs_file.h"
#include "fuzz/promises.h"

using namespace augicp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.txt", data, size);
  fuzz::expect_read_or_refused(file.path, [&] { fuzz::expect_sound(parse_poses(file).content.trajectory); });
  fuzz::expect_read_or_refused(file.path, [&] {
    for (const ReferencePair& pair : parse_reference_pairs(file)) fuzz::expect_rigid(pair.first_from_second);
  });
  return 0;
}
