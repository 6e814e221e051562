// SPDX-License-Identifier: MIT
#include "augicp/io/decompress.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <new>
#include <utility>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"

#ifdef AUGICP_HAS_LZ4
#include <lz4frame.h>
#endif
#ifdef AUGICP_HAS_ZSTD
#include <zstd.h>
#endif
#ifdef AUGICP_HAS_BZIP2
#include <bzlib.h>
#endif

namespace augicp {
namespace {

constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{32} << 20, kMostPerByte = 1024;
constexpr std::size_t kFirstBytes = std::size_t{1} << 20;

// What is left of the input, and where the output goes.
struct Progress {
  std::string_view in;
  char* out;
  std::size_t room;
};

enum class Step { GoesOn, Ended, Failed };

// Consumes some of the input and fills some of the room, and takes both off.
using Decompressor = std::function<Step(Progress&)>;

#ifdef AUGICP_HAS_LZ4
Decompressor lz4_decompressor() {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION))) throw std::bad_alloc();
  const std::shared_ptr<LZ4F_dctx> context(raw, &LZ4F_freeDecompressionContext);
  return [context](Progress& at) {
    std::size_t taken = at.in.size(), made = at.room;
    const std::size_t hint = LZ4F_decompress(context.get(), at.out, &made, at.in.data(), &taken, nullptr);
    if (LZ4F_isError(hint)) return Step::Failed;
    at = {at.in.substr(taken), at.out + made, at.room - made};
    return hint == 0 ? Step::Ended : Step::GoesOn;
  };
}
#endif

#ifdef AUGICP_HAS_ZSTD
Decompressor zstd_decompressor() {
  const std::shared_ptr<ZSTD_DStream> stream(ZSTD_createDStream(), &ZSTD_freeDStream);
  if (!stream) throw std::bad_alloc();
  return [stream](Progress& at) {
    ZSTD_inBuffer in{at.in.data(), at.in.size(), 0};
    ZSTD_outBuffer out{at.out, at.room, 0};
    const std::size_t hint = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(hint)) return Step::Failed;
    at = {at.in.substr(in.pos), at.out + out.pos, at.room - out.pos};
    return hint == 0 ? Step::Ended : Step::GoesOn;
  };
}
#endif

#ifdef AUGICP_HAS_BZIP2
Decompressor bz2_decompressor() {
  const auto finish = [](bz_stream* stream) {
    BZ2_bzDecompressEnd(stream);
    delete stream;
  };
  const std::shared_ptr<bz_stream> stream(new bz_stream(), finish);
  if (BZ2_bzDecompressInit(stream.get(), 0, 0) != BZ_OK) throw std::bad_alloc();
  return [stream](Progress& at) {
    stream->next_in = const_cast<char*>(at.in.data());
    stream->avail_in = static_cast<unsigned>(at.in.size());
    stream->next_out = at.out;
    stream->avail_out = static_cast<unsigned>(at.room);
    const int code = BZ2_bzDecompress(stream.get());
    at = {at.in.substr(at.in.size() - stream->avail_in), stream->next_out, stream->avail_out};
    return code == BZ_STREAM_END ? Step::Ended : code == BZ_OK ? Step::GoesOn : Step::Failed;
  };
}
#endif

// Empty if this build lacks it.
Decompressor decompressor_for([[maybe_unused]] std::string_view compression) {
#ifdef AUGICP_HAS_LZ4
  if (compression == "lz4") return lz4_decompressor();
#endif
#ifdef AUGICP_HAS_ZSTD
  if (compression == "zstd") return zstd_decompressor();
#endif
#ifdef AUGICP_HAS_BZIP2
  if (compression == "bz2") return bz2_decompressor();
#endif
  return {};
}

std::string in_words(std::string_view compression) {
  return compression.empty() ? "a chunk" : "a chunk of " + std::string(compression);
}

// The output, which grows as it is filled, up to a limit.
class Output {
 public:
  explicit Output(std::uint64_t most) : most_(most), bytes_(std::min<std::uint64_t>(most, kFirstBytes), '\0') {}

  // One byte beyond the limit shows that there is more.
  Progress room_for(std::string_view in) {
    if (filled_ == bytes_.size()) bytes_.resize(std::min<std::uint64_t>(2 * bytes_.size() + 1, most_ + 1));
    return {in, bytes_.data() + filled_, bytes_.size() - filled_};
  }

  // Whether something was added.
  bool accept(const Progress& at) {
    const std::uint64_t before = std::exchange(filled_, bytes_.size() - at.room);
    return filled_ > before;
  }

  std::uint64_t size() const { return filled_; }
  std::string taken() && {
    bytes_.resize(filled_);
    return std::move(bytes_);
  }

 private:
  std::uint64_t most_, filled_ = 0;
  std::string bytes_;
};

std::string run(const std::filesystem::path& source, const std::string& what, const Decompressor& step,
                std::string_view bytes, std::uint64_t most) {
  Output output(most);
  for (Step last = Step::GoesOn; last == Step::GoesOn;) {
    Progress at = output.room_for(bytes);
    last = step(at);
    const bool has_grown = output.accept(at), has_moved = has_grown || at.in.size() < bytes.size();
    bytes = at.in;
    if (last == Step::Failed || (last == Step::GoesOn && !has_moved)) throw io_error(source, what + " is damaged");
    if (output.size() > most) throw io_error(source, fmt::format("expected {} with {} bytes, found more", what, most));
  }
  if (!bytes.empty())
    throw io_error(source, fmt::format("{}: expected its end, found {} more bytes", what, bytes.size()));
  return std::move(output).taken();
}

}  // namespace

bool can_decompress(std::string_view compression) {
  return compression.empty() || decompressor_for(compression) != nullptr;
}

bool begins_as_zstd(std::string_view bytes) { return bytes.starts_with("\x28\xb5\x2f\xfd"); }

std::string decompressed(const std::filesystem::path& source, std::string_view compression, std::string_view bytes,
                         std::optional<std::uint64_t> size) {
  const std::string what = in_words(compression);
  const std::uint64_t most = std::max<std::uint64_t>(kAlwaysAllowed, kMostPerByte * bytes.size());
  const auto check_size = [&](std::uint64_t found) {
    if (size && found != *size)
      throw io_error(source, fmt::format("expected {} with {} bytes, found {}", what, *size, found));
  };
  if (compression.empty()) {
    check_size(bytes.size());
    return std::string(bytes);
  }
  if (size.value_or(0) > most)
    throw io_error(source, fmt::format("expected {} with less than {} bytes, found {}", what, most, *size));
  const Decompressor step = decompressor_for(compression);
  if (!step) throw io_error(source, what + ": this build lacks its library");
  std::string content = run(source, what, step, bytes, size.value_or(most));
  check_size(content.size());
  return content;
}

}  // namespace augicp
