// SPDX-License-Identifier: MIT
#include "augicp/testing/decimal_comma.h"

#include <stdexcept>

namespace augicp::testing {

bool DecimalComma::exists() {
  try {
    const DecimalComma comma;
    return std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == ',';
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace augicp::testing
