// SPDX-License-Identifier: MIT
// Code shared by the readers and the writer of PNG files.
#pragma once

#include <spng.h>

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "augicp/io/file_bytes.h"

namespace augicp {

using PngContext = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

// Throws IoError unless the code means success.
void check_png(int code, const std::filesystem::path& path);

// A PNG whose header was read. Throws IoError for damaged files, and for images larger than any sensor's. REQUIRES:
// file outlives it.
class PngReader {
 public:
  explicit PngReader(const FileBytes& file);

  int width() const { return static_cast<int>(header_.width); }
  int height() const { return static_cast<int>(header_.height); }

  // Whether it is not interlaced, and has this depth and colour type.
  bool is(int bit_depth, int color_type) const;
  std::string kind() const;  // in words

  // All pixels as stored in the file, with num_channels channels each. Call once. Throws IoError if the file is cut
  // short.
  template <typename Channel>
  std::vector<Channel> decode(std::size_t num_channels) {
    static_assert(std::is_integral_v<Channel>);
    check_length(num_channels * sizeof(Channel));
    std::vector<Channel> values(num_channels * header_.width * header_.height);
    decode_into(values.data(), values.size() * sizeof(Channel));
    return values;
  }

 private:
  void check_length(std::size_t bytes_per_pixel) const;
  void decode_into(void* values, std::size_t num_bytes);

  const FileBytes& file_;
  PngContext context_;
  spng_ihdr header_{};
};

}  // namespace augicp
