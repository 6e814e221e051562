// SPDX-License-Identifier: MIT
#include "augicp/io/text_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace augicp {
namespace {

using Strings = std::vector<std::string>;

Strings lines_of(std::string_view text) {
  TextLines lines(text);
  Strings found;
  while (const auto line = lines.next()) found.emplace_back(*line);
  EXPECT_EQ(lines.line(), found.size());
  EXPECT_EQ(lines.offset(), text.size());
  return found;
}

Strings fields_of(std::string_view line, char separator) {
  Strings fields;
  const std::size_t count = num_fields(line, separator);
  while (const auto field = next_field(line, separator)) fields.emplace_back(*field);
  EXPECT_EQ(count, fields.size());
  return fields;
}

// robustness 5
TEST(TextLines, LinesEndInLfOrCrLfOrCr) {
  const Strings expected{"a", "", "b c"};
  for (const char* text : {"a\n\nb c\n", "a\r\n\r\nb c\r\n", "a\r\rb c\r", "a\n\nb c", "a\r\n\r\nb c", "a\r\rb c"})
    EXPECT_EQ(lines_of(text), expected);
  EXPECT_EQ(lines_of(""), Strings{});
}

TEST(TextLines, ALineFeedAfterALoneCrIsDataWhereLinesEndInCr) {
  TextLines lines("ply\rend\r\nbody");
  lines.next();
  EXPECT_EQ(*lines.next(), "end");
  EXPECT_EQ(lines.offset(), 8u);
}

TEST(TextLines, FieldsAreSeparatedByBlanksOrBySeparatorsWithBlanks) {
  EXPECT_EQ(fields_of(" 1\t2   3 ", ' '), (Strings{"1", "2", "3"}));
  EXPECT_EQ(fields_of("1 , 2,3 ", ','), (Strings{"1", "2", "3"}));
  EXPECT_EQ(fields_of("1;;3", ';'), (Strings{"1", "", "3"}));
  EXPECT_EQ(fields_of("", ' '), Strings{});
}

TEST(TextLines, QuotesKeepSeparatorsTogether) {
  EXPECT_EQ(fields_of("\"a, b\" , \"1\",\"\",3", ','), (Strings{"a, b", "1", "", "3"}));
  EXPECT_EQ(fields_of("\"say \"\"x;y\"\"\";2", ';'), (Strings{"say \"\"x;y\"\"", "2"}));
  EXPECT_EQ(fields_of("1,\"2,3", ','), (Strings{"1", "\"2,3"})) << "no end";
  EXPECT_EQ(fields_of("\"1\"2,3", ','), (Strings{"\"1\"2,3"})) << "more behind the end";
  EXPECT_EQ(fields_of("1,\"", ','), (Strings{"1", "\""}));
  EXPECT_EQ(separator_of("\"a;b\",2"), ',');
}

TEST(TextLines, ASemicolonMakesCommasPartOfTheFields) {
  EXPECT_EQ(separator_of("1,5;2,5"), ';');
  EXPECT_EQ(separator_of("1,5 2,5"), ',');
  EXPECT_EQ(separator_of("1.5\t2.5"), ' ');
}

}  // namespace
}  // namespace augicp
