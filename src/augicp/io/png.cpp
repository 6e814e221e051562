// SPDX-License-Identifier: MIT
#include "augicp/io/png.h"

#include <algorithm>
#include <new>
#include <string_view>

#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::uint32_t kMaxSide = 16384;          // pixels; above any depth sensor's
constexpr std::size_t kMaxChunkBytes = 8'388'608;  // of one chunk that is not image data, and of all such

// The decoder does not check that the last chunk is complete.
void check_end(const FileBytes& file) {
  constexpr std::string_view kLastChunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  if (file.bytes.rfind(kLastChunk) == std::string::npos)
    throw io_error(file.path, "expected a whole PNG, found no end chunk");
}

}  // namespace

void check_png(int code, const std::filesystem::path& path) {
  if (code != SPNG_OK) throw io_error(path, fmt::format("expected a whole PNG, found: {}", spng_strerror(code)));
}

PngReader::PngReader(const FileBytes& file) : file_(file), context_(spng_ctx_new(0), &spng_ctx_free) {
  if (!context_) throw std::bad_alloc();
  spng_ctx* const context = context_.get();
  // The size is checked before anything is allocated for it.
  check_png(spng_set_image_limits(context, kMaxSide, kMaxSide), file.path);
  check_png(spng_set_chunk_limits(context, kMaxChunkBytes, kMaxChunkBytes), file.path);
  check_png(spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_ERROR), file.path);
  check_png(spng_set_png_buffer(context, file.bytes.data(), file.bytes.size()), file.path);
  check_png(spng_get_ihdr(context, &header_), file.path);
}

bool PngReader::is(int bit_depth, int color_type) const {
  return header_.bit_depth == bit_depth && header_.color_type == color_type &&
         header_.interlace_method == SPNG_INTERLACE_NONE;
}

std::string PngReader::kind() const {
  constexpr const char* kColours[] = {"grey", "?", "RGB", "palette", "grey with alpha", "?", "RGB with alpha"};
  return fmt::format("{}-bit {}{}", header_.bit_depth, kColours[std::min<int>(header_.color_type, 6)],
                     header_.interlace_method == SPNG_INTERLACE_NONE ? "" : ", interlaced");
}

// Deflate expands one byte to at most 1032.
void PngReader::check_length(std::size_t bytes_per_pixel) const {
  if (std::uint64_t{bytes_per_pixel} * header_.width * header_.height / 1032 <= file_.bytes.size()) return;
  throw io_error(file_.path, fmt::format("expected {} x {} pixels, the file is too short for them", width(), height()));
}

void PngReader::decode_into(void* values, std::size_t num_bytes) {
  check_png(spng_decode_image(context_.get(), values, num_bytes, SPNG_FMT_PNG, 0), file_.path);
  check_png(spng_decode_chunks(context_.get()), file_.path);
  check_end(file_);
}

}  // namespace augicp
