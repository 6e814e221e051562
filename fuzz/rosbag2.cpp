// SPDX-License-Identifier: MIT
#include "augicp/io/atomic_file.h"
#include "augicp/io/bag.h"
#include "augicp/testing/temporary_folder.h"
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const augicp::testing::TemporaryFolder folder;
  const std::filesystem::path path = folder / "any.db3";
  augicp::write_file(path, augicp::fuzz::file_of(path, data, size).bytes);
  augicp::fuzz::expect_read_or_refused(path, [&] { augicp::bag_topics(path); });
  return 0;
}
