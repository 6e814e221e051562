// SPDX-License-Identifier: MIT
#include "augicp/io/parse_number.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "augicp/testing/decimal_comma.h"

namespace augicp {
namespace {

TEST(ParseNumber, ReadsEverySpellingFilesUse) {
  const std::pair<const char*, double> cases[] = {{"0", 0.0},     {"-1.5", -1.5},   {"+2", 2.0},     {".25", 0.25},
                                                  {"3.", 3.0},    {"1e3", 1000.0},  {"1E-3", 0.001}, {"000", 0.0},
                                                  {"-0.0", -0.0}, {"1e308", 1e308}, {"+.5", 0.5},    {"5e-324", 5e-324},
                                                  {"1e-400", 0.0}};
  for (const auto& [text, value] : cases) {
    const auto parsed = parse_double(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(*parsed, value) << text;
  }
}

TEST(ParseNumber, NotFiniteIsANumberThatIsNotFinite) {
  for (const char* text : {"nan", "NaN", "-nan", "inf", "-Inf", "infinity", "1e400", "-1e400"}) {
    const auto parsed = parse_double(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_FALSE(std::isfinite(*parsed)) << text;
  }
  EXPECT_EQ(parse_double(std::string(400, '9')), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("0." + std::string(400, '0') + "1"), 0.0);
}

TEST(ParseNumber, SeventeenDigitsAreEveryNumberAgain) {
  std::mt19937_64 random(26);
  for (int i = 0; i < 20000; ++i) {
    const double number = std::bit_cast<double>(random());
    if (!std::isfinite(number)) continue;
    const auto parsed = parse_double(fmt::format("{:.17g}", number));
    ASSERT_TRUE(parsed) << number;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*parsed), std::bit_cast<std::uint64_t>(number));
  }
}

TEST(ParseNumber, RefusesWhatIsNotAllANumber) {
  for (const char* text : {"",    " ", "x",   "1,5",  "1.5 ", " 1.5",   "1.5m", "+-1", "++1", "0x10", "1e",
                           "--1", ".", "\t1", "-\n1", "1\v",  "-0x1p3", "nan ", "1_0", "e5",  "+ 1"})
    EXPECT_FALSE(parse_double(text)) << '"' << text << '"';
  EXPECT_FALSE(parse_double(std::string("1\0", 2)));
}

TEST(ParseNumber, CountsAreDigitsBelowTwoToThe64) {
  EXPECT_EQ(parse_count("0"), 0u);
  EXPECT_EQ(parse_count("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  for (const char* text : {"", "-1", "+1", "1.0", "nan", "18446744073709551616", "1e9", " 1"})
    EXPECT_FALSE(parse_count(text)) << '"' << text << '"';
}

// robustness 6
TEST(ParseNumber, TheLocaleDoesNotMatter) {
  if (!testing::DecimalComma::exists()) GTEST_SKIP() << "no locale de_DE.UTF-8, and the build could make none";
  const testing::DecimalComma comma;
  EXPECT_EQ(parse_double("1.5"), 1.5);
  EXPECT_FALSE(parse_double("1,5"));
}

}  // namespace
}  // namespace augicp
