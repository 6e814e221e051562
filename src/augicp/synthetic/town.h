// SPDX-License-Identifier: MIT
// A drive around a block of a generated town, with exact poses: for errors of long trajectories.
#pragma once

#include "augicp/synthetic/lidar.h"

namespace augicp::synthetic {

struct TownOptions {
  double length = 500.0;  // of the loop, metres, from 200 to 100 000
  double speed = 10.0;    // on straight roads, m/s, from 0.1 to 1000; half of it in the curves
  bool has_traffic = true;
  unsigned seed = 1;

  // Throws std::invalid_argument naming the first number out of its range.
  void check() const;
};

// A closed road with houses, parked cars and poles on both sides; a van ahead in the same lane, oncoming cars, and
// people on the pavement. World: z up, the ground at zero.
struct TownLoop {
  World world;
  Motion world_from_sensor;  // repeats itself after each lap
  double lap_s = 0.0;        // duration of a lap
};
TownLoop town_loop(const TownOptions& options);

}  // namespace augicp::synthetic
