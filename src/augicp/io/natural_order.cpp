// SPDX-License-Identifier: MIT
#include "augicp/io/natural_order.h"

namespace augicp {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool naturally_before(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
      continue;
    }
    std::size_t i_end = i, k_end = k;
    while (i_end < a.size() && is_digit(a[i_end])) ++i_end;
    while (k_end < b.size() && is_digit(b[k_end])) ++k_end;
    while (i < i_end && a[i] == '0') ++i;
    while (k < k_end && b[k] == '0') ++k;
    if (i_end - i != k_end - k) return i_end - i < k_end - k;
    const int order = a.compare(i, i_end - i, b, k, k_end - k);
    if (order != 0) return order < 0;
    i = i_end, k = k_end;
  }
  if (a.size() - i != b.size() - k) return a.size() - i < b.size() - k;
  return a < b;
}

}  // namespace augicp
