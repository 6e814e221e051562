// SPDX-License-Identifier: MIT
// For the fuzzers of PNG readers: after each change the chunks' checksums are made right again, most of the time. Else
// hardly any input would pass the check of them.
#include <cstddef>
#include <cstdint>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) {
  std::uint32_t crc = 0xffffffff;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= data[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1)));
  }
  return ~crc;
}

std::uint32_t big_endian(const std::uint8_t* at) {
  return std::uint32_t{at[0]} << 24 | std::uint32_t{at[1]} << 16 | std::uint32_t{at[2]} << 8 | at[3];
}

void make_checksums_right(std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMark = 8, kAround = 12;  // length, kind and checksum of a chunk
  for (std::size_t at = kMark; at + kAround <= size;) {
    const std::size_t length = big_endian(data + at);
    if (length > size - at - kAround) return;
    const std::uint32_t crc = crc32(data + at + 4, 4 + length);
    for (int byte = 0; byte < 4; ++byte)
      data[at + 8 + length + byte] = static_cast<std::uint8_t>(crc >> (24 - 8 * byte));
    at += kAround + length;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  const std::size_t new_size = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 8 != 0) make_checksums_right(data, new_size);
  return new_size;
}
