// SPDX-License-Identifier: MIT
#include "augicp/io/text_lines.h"

#include <algorithm>

namespace augicp {
namespace {

constexpr std::string_view kBlanks = " \t";

char end_of_line(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  const bool lone_cr = end != std::string_view::npos && text[end] == '\r' && !text.substr(end + 1).starts_with('\n');
  return lone_cr ? '\r' : '\n';
}

}  // namespace

TextLines::TextLines(std::string_view text) : text_(text), end_of_line_(end_of_line(text)) {}

std::optional<std::string_view> TextLines::next() {
  if (at_end()) return std::nullopt;
  const std::size_t end = std::min(text_.find(end_of_line_, offset_), text_.size());
  std::string_view line = text_.substr(offset_, end - offset_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  offset_ = std::min(end + 1, text_.size());
  ++line_;
  return line;
}

std::optional<std::string_view> TextLines::next_not_blank() {
  while (const auto line = next())
    if (line->find_first_not_of(kBlanks) != std::string_view::npos) return line;
  return std::nullopt;
}

bool ends_with_a_line_end(std::string_view text) { return text.ends_with('\n') || text.ends_with('\r'); }

std::string_view without_bom(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::optional<std::string_view> next_field(std::string_view& rest, char separator) {
  const std::size_t begin = std::min(rest.find_first_not_of(kBlanks), rest.size());
  rest.remove_prefix(begin);
  if (rest.empty()) return std::nullopt;
  const std::size_t end = std::min(separator == ' ' ? rest.find_first_of(kBlanks) : rest.find(separator), rest.size());
  const std::string_view field = trimmed(rest.substr(0, end));
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return field;
}

std::size_t num_fields(std::string_view line, char separator) {
  std::size_t count = 0;
  while (next_field(line, separator)) ++count;
  return count;
}

char separator_of(std::string_view line) {
  for (const char separator : {';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

}  // namespace augicp
