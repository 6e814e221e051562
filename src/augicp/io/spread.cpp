// SPDX-License-Identifier: MIT
#include "augicp/io/spread.h"

#include "augicp/core/median.h"

namespace augicp {

Spread spread_of(std::size_t count, const std::function<Vec3d(std::size_t)>& point) {
  constexpr std::size_t kMaxSample = 4096;
  const std::size_t step = (count + kMaxSample - 1) / kMaxSample;
  Spread spread;
  std::vector<double> values;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (std::size_t i = 0; i < count; i += step) values.push_back(point(i)[axis]);
    spread.centre[axis] = upper_median(values);
  }
  values.clear();
  for (std::size_t i = 0; i < count; i += step) values.push_back((point(i) - spread.centre).cwiseAbs().maxCoeff());
  spread.radius = upper_median(values);
  return spread;
}

bool float_suffices(const Spread& spread) {
  constexpr double kFarInRadii = 8.0;
  return spread.centre.cwiseAbs().maxCoeff() <= kFarInRadii * spread.radius;
}

}  // namespace augicp
