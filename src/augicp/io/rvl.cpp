// SPDX-License-Identifier: MIT
#include "augicp/io/rvl.h"

#include "augicp/io/scalar_type.h"

namespace augicp {
namespace {

// Numbers of 3 bits a nibble, the least significant first; the highest bit of a nibble says that another follows.
// Nibbles fill words of 32 bits from the top.
class NibbleReader {
 public:
  explicit NibbleReader(std::string_view bytes) : bytes_(bytes) {}

  // Empty behind the last word, and for numbers beyond 32 bits.
  std::optional<std::uint32_t> next() {
    std::uint64_t number = 0;
    for (int shift = 0; shift <= 30; shift += 3) {
      const auto nibble = next_nibble();
      if (!nibble) return std::nullopt;
      number |= std::uint64_t{*nibble & 7} << shift;
      if ((*nibble & 8) == 0)
        return number >> 32 == 0 ? std::optional(static_cast<std::uint32_t>(number)) : std::nullopt;
    }
    return std::nullopt;
  }

  bool has_whole_words() const { return bytes_.size() >= kWordBytes; }

 private:
  static constexpr std::size_t kWordBytes = 4;

  std::optional<std::uint32_t> next_nibble() {
    if (num_nibbles_ == 0) {
      if (!has_whole_words()) return std::nullopt;
      word_ = static_cast<std::uint32_t>(read_scalar(bytes_.data(), ScalarType::Uint32, ByteOrder::Little));
      bytes_.remove_prefix(kWordBytes);
      num_nibbles_ = 2 * kWordBytes;
    }
    return word_ >> 4 * --num_nibbles_ & 15;
  }

  std::string_view bytes_;
  std::uint32_t word_ = 0;
  std::size_t num_nibbles_ = 0;
};

}  // namespace

std::optional<std::vector<std::uint16_t>> rvl_pixels(std::string_view bytes, std::size_t count) {
  constexpr std::int64_t kLargest = 65535;
  std::vector<std::uint16_t> pixels;
  NibbleReader reader(bytes);
  std::int64_t value = 0;
  while (pixels.size() < count) {
    const auto num_zeros = reader.next();
    if (!num_zeros || *num_zeros > count - pixels.size()) return std::nullopt;
    pixels.resize(pixels.size() + *num_zeros, 0);
    const auto num_values = reader.next();
    if (!num_values || *num_values > count - pixels.size()) return std::nullopt;
    for (std::uint32_t i = 0; i < *num_values; ++i) {
      const auto folded = reader.next();  // 0 -1 1 -2 2 ... as 0 1 2 3 4 ...
      if (!folded) return std::nullopt;
      const std::int64_t half = *folded >> 1;
      value += (*folded & 1) != 0 ? -half - 1 : half;
      if (value < 0 || value > kLargest) return std::nullopt;
      pixels.push_back(static_cast<std::uint16_t>(value));
    }
  }
  if (reader.has_whole_words()) return std::nullopt;
  return pixels;
}

}  // namespace augicp
