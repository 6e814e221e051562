// SPDX-License-Identifier: MIT
// Generated measurements of a spinning LiDAR, with the exact truth.
#pragma once

#include <functional>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/testing/scene.h"

namespace augicp::synthetic {

// A spinning scanner at the zero of its frame, z up along its axis. Ring k looks along an elevation that grows evenly
// with k. All rings fire together, at num_azimuths evenly spaced azimuths, counterclockwise from the x axis.
struct Lidar {
  int num_rings = 64;                // at least 1
  int num_azimuths = 1024;           // of a revolution, at least 1
  double min_elevation_deg = -25.0;  // of the first ring
  double max_elevation_deg = 15.0;   // of the last ring
  double min_range = 0.5;            // metres; nearer and farther surfaces return nothing
  double max_range = 60.0;           // metres
  double range_sigma = 0.01;         // standard deviation of the range noise, metres
  double sweep_s = 0.1;              // duration of a revolution

  // Throws std::invalid_argument naming the first number out of its range.
  void check() const;
};

// A pose over time, seconds. Must be callable for all times within the sweep.
using Motion = std::function<Rigid3(double time_s)>;

inline Motion standing_at(const Rigid3& pose) {
  return [pose](double) { return pose; };
}

// Even motion: the pose at time zero, times the motion of one second scaled by the time.
Motion moving_evenly(const Rigid3& world_from_body_at_zero, const Rigid3& motion_of_one_second);

// A rigid object that moves through the scene.
struct MovingObject {
  testing::Scene scene;  // in the object's own frame
  Motion world_from_object;
};

struct World {
  testing::Scene scene;
  std::vector<MovingObject> moving;
};

// One revolution. Arrays have one entry per point, in order of time, then of ring.
struct Sweep {
  static constexpr int kMoving = -1;

  Cloud cloud;                  // metres, each point in the sensor's frame at its own time; the viewpoint is zero
  std::vector<double> times_s;  // from the start of the sweep
  std::vector<int> rings;
  std::vector<int> surfaces;  // number in the world's scene; kMoving on a moving object
};

// Scans a world during one revolution. world_from_sensor and the poses of moving objects are evaluated at times in
// [begin_s, begin_s + sweep_s). The noise is drawn from the seed. Rays without a surface in range give no point.
Sweep scan(const World& world, const Lidar& lidar, const Motion& world_from_sensor, unsigned seed,
           double begin_s = 0.0);

// The same for a sensor at rest in a world without moving objects: the cloud alone.
Cloud scan(const testing::Scene& scene, const Lidar& lidar, const Rigid3& world_from_sensor, unsigned seed);

// What fraction of the light each point's surface returns, in [0.1, 1]: one number a surface, 1 on moving objects.
std::vector<float> reflectivities(const Sweep& sweep);

// The points of a sweep in the sensor's frame at one time (seconds from the start of the sweep), by the true motion.
Cloud straightened(const Sweep& sweep, const Motion& world_from_sensor, double begin_s, double frame_time_s);

}  // namespace augicp::synthetic
