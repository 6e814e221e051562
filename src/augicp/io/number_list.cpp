// SPDX-License-Identifier: MIT
#include "augicp/io/number_list.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

// The brackets around rows, as NumPy prints them, are blanks.
std::string without_brackets(std::string_view line) {
  std::string content(line);
  std::replace_if(
      content.begin(), content.end(), [](char c) { return c == '[' || c == ']'; }, ' ');
  return content;
}

}  // namespace

std::vector<double> parse_number_list(std::string_view what, std::string_view text, std::size_t max_count) {
  TextLines lines(without_bom(text));
  std::vector<double> numbers;
  while (const auto line = lines.next()) {
    const std::string content = without_brackets(line->substr(0, line->find('#')));
    std::string_view rest = content;
    const char separator = separator_of(rest);
    while (const auto field = next_field(rest, separator)) {
      const auto number = parse_double(*field);
      if (!number)
        throw std::invalid_argument(
            fmt::format("{}: line {}: expected a number, found {}", what, lines.line(), in_quotes(*field)));
      if (numbers.size() == max_count)
        throw std::invalid_argument(
            fmt::format("{}: line {}: expected at most {} numbers", what, lines.line(), max_count));
      numbers.push_back(*number);
    }
  }
  return numbers;
}

bool starts_like_json(std::string_view text) {
  text = without_bom(text);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{';
}

}  // namespace augicp
