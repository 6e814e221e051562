// SPDX-License-Identifier: MIT
#pragma once

#include <locale>

namespace augicp::testing {

// While it lives the process has a locale that writes 1,5 for 1.5, for C's functions and for streams made meanwhile.
// Throws std::runtime_error where there is no such locale; ctest names the folder of one that the build made.
class DecimalComma {
 public:
  DecimalComma() : before_(std::locale::global(std::locale("de_DE.UTF-8"))) {}
  ~DecimalComma() { std::locale::global(before_); }
  DecimalComma(const DecimalComma&) = delete;
  DecimalComma& operator=(const DecimalComma&) = delete;

  // Whether this process can have one. Tests that need it are skipped without.
  static bool exists();

 private:
  std::locale before_;
};

}  // namespace augicp::testing
