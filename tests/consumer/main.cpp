// SPDX-License-Identifier: MIT
#include <cstdio>

#include "augicp/augicp.h"

int main() {
  augicp::Cloud cloud;
  for (int i = 0; i < 5000; ++i) cloud.points.emplace_back(0.001f * static_cast<float>(i), 0.0f, 2.0f);
  const augicp::Cloud coarse = augicp::downsample(cloud, 0.5);
  std::printf("%zu points of %zu\n", coarse.size(), cloud.size());
  return coarse.empty() || coarse.size() > 20;
}
