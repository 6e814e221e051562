// SPDX-License-Identifier: MIT
#include "augicp/io/message_reader.h"

#include <utility>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"

namespace augicp {

MessageReader::MessageReader(const std::filesystem::path& source, std::string_view type, std::string_view message,
                             MessageForm form)
    : source_(source), type_(type), message_(message), form_(form) {
  if (form == MessageForm::Ros1) return;
  const std::string_view head = take_bytes(4);
  if (head[0] != 0 || (head[1] != 0 && head[1] != 1)) fail("expected CDR, plain");
  order_ = head[1] == 0 ? ByteOrder::Big : ByteOrder::Little;
  begin_ = at_;
}

void MessageReader::fail(std::string_view what) const {
  throw io_error(source_, fmt::format("{}, byte {}: {}", type_, at_, what));
}

const char* MessageReader::take_number(ScalarType type) {
  align(num_bytes(type));
  return take_bytes(num_bytes(type)).data();
}

std::uint64_t MessageReader::take(ScalarType type) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(read_scalar(take_number(type), type, order_)));
}

double MessageReader::take_double() {
  return read_scalar(take_number(ScalarType::Float64), ScalarType::Float64, order_);
}

// Strings of CDR end in a zero, which counts.
std::string MessageReader::take_text() {
  std::string_view text = take_bytes(take_count());
  if (form_ == MessageForm::Cdr && text.ends_with('\0')) text.remove_suffix(1);
  return std::string(text);
}

std::string_view MessageReader::take_bytes(std::uint64_t count) {
  if (count > message_.size() - at_) fail(fmt::format("expected {} bytes, the message ends", count));
  return message_.substr(std::exchange(at_, at_ + count), count);
}

MessageHeader MessageReader::take_header() {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  if (form_ == MessageForm::Ros1) take_count();  // a running number
  const auto seconds =
      static_cast<std::int64_t>(take(form_ == MessageForm::Ros1 ? ScalarType::Uint32 : ScalarType::Int32));
  const std::int64_t stamp_ns = seconds * kNanoseconds + static_cast<std::int64_t>(take_count());
  return {stamp_ns, take_text()};
}

void MessageReader::align(std::size_t size) {
  if (form_ == MessageForm::Ros1) return;
  const std::size_t excess = (at_ - begin_) % size;
  if (excess > 0) take_bytes(size - excess);
}

}  // namespace augicp
