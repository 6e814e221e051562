// SPDX-License-Identifier: MIT
#pragma once

#include <locale>
#include <string>

namespace augicp::testing {

// While it lives the process has a locale that writes 1,5 for 1.5, for C's functions and for streams made meanwhile.
// Throws std::runtime_error where C has no such locale; ctest names the folder of one that the build made.
class DecimalComma {
 public:
  DecimalComma();
  ~DecimalComma();
  DecimalComma(const DecimalComma&) = delete;
  DecimalComma& operator=(const DecimalComma&) = delete;

  // Whether this process can have one. Tests that need it are skipped without.
  static bool exists();

 private:
  std::string c_before_;
  std::locale before_;
};

}  // namespace augicp::testing
