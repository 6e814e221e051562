// SPDX-License-Identifier: MIT
#include "apps/augicp/page/length_text.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace augicp::app {
namespace {

struct LengthUnit {
  double metres = 1.0;
  const char* name = "m";
};
constexpr std::array<LengthUnit, 5> kUnits = {{{1000.0, "km"}, {1.0, "m"}, {0.01, "cm"}, {0.001, "mm"}, {1e-6, "µm"}}};
constexpr const char* kNoBreakSpace = "\xc2\xa0";

}  // namespace

std::string length_text(double length_m) {
  if (length_m == 0.0 || !std::isfinite(length_m)) return fmt::format("{}{}m", length_m, kNoBreakSpace);
  LengthUnit unit = kUnits.back();
  for (auto candidate = kUnits.rbegin(); candidate != kUnits.rend(); ++candidate)
    if (std::abs(length_m) >= candidate->metres) unit = *candidate;
  return fmt::format("{:.3g}{}{}", length_m / unit.metres, kNoBreakSpace, unit.name);
}

}  // namespace augicp::app
