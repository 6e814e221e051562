// SPDX-License-Identifier: MIT
#include "augicp/io/gltf_file.h"

#include <algorithm>
#include <array>

#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kGlbHeader = 12, kChunkHeader = 8;
constexpr std::uint64_t kJson = 0x4e4f534a, kBinary = 0x004e4942;  // "JSON", "BIN\0"

std::uint64_t number_at(const FileBytes& file, std::size_t at) {
  if (file.bytes.size() < at + 4)
    throw io_error_at_byte(file.path, file.bytes.size(), "expected a chunk of a .glb file, the file ends here");
  return static_cast<std::uint64_t>(read_scalar(file.bytes.data() + at, ScalarType::Uint32, ByteOrder::Little));
}

// The chunk at this byte.
std::string_view chunk_at(const FileBytes& file, std::size_t at) {
  const std::uint64_t length = number_at(file, at);
  if (length > file.bytes.size() - std::min(file.bytes.size(), at + kChunkHeader))
    throw io_error_at_byte(file.path, at, fmt::format("expected a chunk of {} bytes, the file ends before", length));
  return std::string_view(file.bytes).substr(at + kChunkHeader, length);
}

GltfText glb_text(const FileBytes& file) {
  if (const std::uint64_t version = number_at(file, 4); version != 2)
    throw io_error_at_byte(file.path, 4, fmt::format("expected version 2 of glTF, found {}", version));
  if (const std::uint64_t length = number_at(file, 8); length != file.bytes.size())
    throw io_error_at_byte(file.path, 8, fmt::format("expected {} bytes, found {}", length, file.bytes.size()));
  if (number_at(file, kGlbHeader + 4) != kJson)
    throw io_error_at_byte(file.path, kGlbHeader, "expected a chunk 'JSON'");
  GltfText text{chunk_at(file, kGlbHeader), std::nullopt};
  const std::size_t next = kGlbHeader + kChunkHeader + text.json.size();
  if (next < file.bytes.size() && number_at(file, next + 4) == kBinary) text.binary = chunk_at(file, next);
  return text;
}

// RFC 4648, with or without '=' at the end.
std::optional<std::string> from_base64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<signed char, 256> value_of{};
  value_of.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    value_of[static_cast<unsigned char>(kDigits[i])] = static_cast<signed char>(i);
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0, num_bits = 0;
  for (const char c : text) {
    const signed char value = value_of[static_cast<unsigned char>(c)];
    if (value < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xffffff;
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    bytes += static_cast<char>(bits >> num_bits & 255);
  }
  return bytes;
}

// "%20" as a blank.
std::string percent_decoded(std::string_view uri) {
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || ((c | 32) >= 'a' && (c | 32) <= 'f'); };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_code = uri[i] == '%' && i + 2 < uri.size() && is_digit(uri[i + 1]) && is_digit(uri[i + 2]);
    text += is_code ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (is_code) i += 2;
  }
  return text;
}

}  // namespace

GltfText gltf_text(const FileBytes& file) {
  if (file.bytes.starts_with("glTF")) return glb_text(file);
  return {file.bytes, std::nullopt};
}

std::optional<std::string> gltf_data(const FileBytes& file, std::string_view uri) {
  constexpr std::string_view kMark = ";base64,";
  if (!uri.starts_with("data:")) return std::nullopt;
  const std::size_t at = uri.find(kMark);
  auto bytes = at == std::string_view::npos ? std::nullopt : from_base64(uri.substr(at + kMark.size()));
  if (!bytes) throw io_error(file.path, "expected a buffer in base64, found " + in_quotes(uri));
  return bytes;
}

std::filesystem::path gltf_buffer_path(const FileBytes& file, std::string_view uri) {
  const std::filesystem::path name = percent_decoded(uri);
  const bool is_outside = name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end();
  if (is_outside || uri.empty() || uri.find(':') != std::string_view::npos)
    throw io_error(file.path, "expected the name of a buffer beside the file, found " + in_quotes(uri));
  return (file.path.parent_path() / name).lexically_normal();
}

}  // namespace augicp
