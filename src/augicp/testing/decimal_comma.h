// SPDX-License-Identifier: MIT
#pragma once

#include <locale>
#include <string>

namespace augicp::testing {

// During its lifetime the process has a locale that writes 1,5 for 1.5, for C functions and for streams made meanwhile.
// Throws std::runtime_error if C has no such locale; ctest names the folder of one that the build made.
class DecimalComma {
 public:
  DecimalComma();
  ~DecimalComma();
  DecimalComma(const DecimalComma&) = delete;
  DecimalComma& operator=(const DecimalComma&) = delete;

  // Whether this process can have one. Without it, tests that need it are skipped.
  static bool exists();

 private:
  std::string c_before_;
  std::locale before_;
};

}  // namespace augicp::testing
