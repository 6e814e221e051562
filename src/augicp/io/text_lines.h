// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace augicp {

// Bytes. A longer line is not of a header in text: the file is another one.
inline constexpr std::size_t kMaxHeaderLine = 65'536;

// The lines of a text, ended by LF, CR LF or CR. A text whose first line ends in a lone CR has CR lines throughout.
// Lines are views into the text. REQUIRES: the text outlives them.
class TextLines {
 public:
  explicit TextLines(std::string_view text);

  // The next line without its end; empty after the last. The last line needs no end.
  std::optional<std::string_view> next();

  // The same for the next line that is not blank.
  std::optional<std::string_view> next_not_blank();

  std::uint64_t line() const { return line_; }    // number of the last returned line, from 1
  std::size_t offset() const { return offset_; }  // offset of the next line in the text
  bool at_end() const { return offset_ >= text_.size(); }

 private:
  std::string_view text_;
  char end_of_line_;
  std::size_t offset_ = 0;
  std::uint64_t line_ = 0;
};

// True unless the text ends within a line: then the file may have been cut short without any other sign.
bool ends_with_a_line_end(std::string_view text);

// The text without a UTF-8 byte order mark.
std::string_view without_bom(std::string_view text);

// The text without blanks (space, tab) at its ends.
std::string_view trimmed(std::string_view text);

// Takes the next field off the front of rest; empty if none is left. Fields are separated by blanks (separator ' '), or
// by the separator with optional blanks around it, which are not part of the field. With a separator, fields in double
// quotes lose them and may contain it; quotes that do not end before a separator take the whole rest.
std::optional<std::string_view> next_field(std::string_view& rest, char separator = ' ');

// Number of fields of a line.
std::size_t num_fields(std::string_view line, char separator = ' ');

// The separator of the fields of this line, by what is outside of quotes: a semicolon if there is one, else a comma if
// there is one, else blanks. So neither "1,5;2,5" nor "1,5 2,5" is read as four numbers.
char separator_of(std::string_view line);

}  // namespace augicp
