// SPDX-License-Identifier: MIT
// Chunks of recordings: plain, lz4 (frames), zstd, bz2. The last three are read if the build found their libraries.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace augicp {

// Whether this build reads the compression; "" is none.
bool can_decompress(std::string_view compression);

// The content of compressed bytes, which are whole. size: how long it is, if that is known. Memory is bounded by the
// content, and the content by 32 MiB or 1024 times the compressed bytes, whichever is more. Throws IoError for damage,
// for another size, and for more. REQUIRES: can_decompress(compression).
std::string decompressed(const std::filesystem::path& source, std::string_view compression, std::string_view bytes,
                         std::optional<std::uint64_t> size);

// Whether the bytes begin with the mark of zstd.
bool begins_as_zstd(std::string_view bytes);

}  // namespace augicp
