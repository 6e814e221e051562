// SPDX-License-Identifier: MIT
#include "apps/augicp/page/deflate.h"

#include <zlib.h>

#include <new>

namespace augicp::app {

std::vector<std::byte> deflated(std::span<const std::uint8_t> bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::byte> packed(size);
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes.data(),
                               static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw std::bad_alloc();  // the only way to fail with a large enough buffer
  packed.resize(size);
  return packed;
}

}  // namespace augicp::app
