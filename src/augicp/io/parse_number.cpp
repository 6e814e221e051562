// SPDX-License-Identifier: MIT
#include "augicp/io/parse_number.h"

#include <charconv>
#include <limits>
#include <system_error>

// libc++ before version 20 reads no double without a locale. Then the C library does, with its own locale.
#if !defined(__cpp_lib_to_chars) || defined(AUGICP_NO_FROM_CHARS)
#define AUGICP_READS_BY_STRTOD
#include <clocale>
#include <cstdlib>
#include <string>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

namespace augicp {
namespace {

#ifdef AUGICP_READS_BY_STRTOD

// The locale "C" for one call, whatever the program's is. Making it opens no file.
class PlainLocale {
 public:
  PlainLocale() : locale_(newlocale(LC_ALL_MASK, "C", nullptr)) {}
  PlainLocale(const PlainLocale&) = delete;
  PlainLocale& operator=(const PlainLocale&) = delete;
  ~PlainLocale() { freelocale(locale_); }
  locale_t get() const { return locale_; }

 private:
  locale_t locale_;
};

// strtod also skips white space, and reads a plus and hexadecimal digits. It returns infinity and zero where the number
// is out of range.
std::optional<double> unsigned_or_negative(std::string_view text) {
  if (text.empty() || text.find_first_of("xX \t\n\v\f\r") != std::string_view::npos) return std::nullopt;
  const std::string terminated(text);
  char* stop = nullptr;
  const double value = strtod_l(terminated.c_str(), &stop, PlainLocale().get());
  if (stop != terminated.c_str() + terminated.size()) return std::nullopt;
  return value;
}

#else

// from_chars reports "out of range" for both ends. A negative exponent, or a leading zero without an exponent, means
// too small.
double limit_of(std::string_view digits) {
  const bool negative = digits.starts_with('-');
  if (negative) digits.remove_prefix(1);
  const std::size_t exponent = digits.find_first_of("eE");
  const bool tiny = exponent == std::string_view::npos ? digits.find_first_of("0.") == 0
                                                       : digits.substr(exponent + 1).starts_with('-');
  const double magnitude = tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return negative ? -magnitude : magnitude;
}

std::optional<double> unsigned_or_negative(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? limit_of(text) : value;
}

#endif

}  // namespace

std::optional<double> parse_double(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  }
  return unsigned_or_negative(text);
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty() || error != std::errc{}) return std::nullopt;
  return value;
}

}  // namespace augicp
