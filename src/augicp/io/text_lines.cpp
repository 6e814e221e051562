// SPDX-License-Identifier: MIT
#include "augicp/io/text_lines.h"

#include <algorithm>
#include <utility>

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

namespace {

// The place behind the quote that ends the field; a doubled quote is a part of it.
std::size_t end_of_quoted(std::string_view text) {
  std::size_t at = 1;
  while (at < text.size()) {
    if (text[at++] != '"') continue;
    if (at == text.size() || text[at] != '"') return at;
    ++at;
  }
  return std::string_view::npos;
}

// A field in quotes, whose separators are a part of it. What is no such field is the whole rest, with its quotes.
std::string_view next_quoted(std::string_view& rest, char separator) {
  const std::size_t end = end_of_quoted(rest);
  const std::size_t next = end > rest.size() ? end : rest.find_first_not_of(kBlanks, end);
  if (end > rest.size() || (next < rest.size() && rest[next] != separator)) return std::exchange(rest, {});
  const std::string_view field = rest.substr(1, end - 2);
  rest.remove_prefix(std::min(next, rest.size() - 1) + 1);
  return field;
}

}  // namespace

std::optional<std::string_view> next_field(std::string_view& rest, char separator) {
  const std::size_t begin = std::min(rest.find_first_not_of(kBlanks), rest.size());
  rest.remove_prefix(begin);
  if (rest.empty()) return std::nullopt;
  if (separator != ' ' && rest.front() == '"') return next_quoted(rest, separator);
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
  bool is_quoted = false, has_comma = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ';' && !is_quoted) return ';';
    has_comma = has_comma || (c == ',' && !is_quoted);
  }
  return has_comma ? ',' : ' ';
}

}  // namespace augicp
