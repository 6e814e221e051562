// SPDX-License-Identifier: MIT
#include "augicp/testing/decimal_comma.h"

#include <clocale>
#include <stdexcept>
#include <string_view>

namespace augicp::testing {
namespace {

class CommaPunctuation : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

}  // namespace

// Streams have punctuation of their own: std::locale("de_DE.UTF-8") asks the C library for a locale object, which loses
// memory where the environment names a folder of locales.
DecimalComma::DecimalComma()
    : c_before_(std::setlocale(LC_ALL, nullptr)),
      before_(std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation))) {
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr && std::string_view(std::localeconv()->decimal_point) == ",")
    return;
  std::locale::global(before_);
  std::setlocale(LC_ALL, c_before_.c_str());
  throw std::runtime_error("no locale de_DE.UTF-8 with a decimal comma");
}

DecimalComma::~DecimalComma() {
  std::locale::global(before_);
  std::setlocale(LC_ALL, c_before_.c_str());
}

bool DecimalComma::exists() {
  try {
    const DecimalComma comma;
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace augicp::testing
