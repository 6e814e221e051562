// SPDX-License-Identifier: MIT
#include <cstdio>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/sensor/projection.h"

int main() {
  augicp::Cloud cloud;
  for (int i = 0; i < 5000; ++i) cloud.points.emplace_back(0.001f * static_cast<float>(i), 0.0f, 2.0f);
  const augicp::Cloud coarse = augicp::downsample(cloud, 0.5);
  const auto seen = augicp::project(coarse, augicp::Rigid3{}, {525.0, 525.0, 319.5, 239.5}, 640, 480, 2);
  std::printf("%zu points in %zu pixels\n", coarse.size(), seen.index.size());
  return coarse.empty() || coarse.size() > 20;
}
