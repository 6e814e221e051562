// SPDX-License-Identifier: MIT
// read_transform() puts the path before the std::invalid_argument that the parser throws.
#include <stdexcept>

#include "augicp/io/transform_file.h"
#include "fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    augicp::fuzz::expect_rigid(augicp::parse_transform(text));
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
