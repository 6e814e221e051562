// SPDX-License-Identifier: MIT
#include "augicp/synthetic/lidar.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "augicp/core/angles.h"
#include "augicp/core/check.h"
#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"

namespace augicp::synthetic {
namespace {

using testing::Ray;
using testing::Scene;

Vec3d direction_of(const Lidar& lidar, int ring, int azimuth) {
  const double step_deg =
      lidar.num_rings > 1 ? (lidar.max_elevation_deg - lidar.min_elevation_deg) / (lidar.num_rings - 1) : 0.0;
  const double elevation = (lidar.min_elevation_deg + ring * step_deg) * kRadPerDeg;
  const double angle = 2.0 * std::numbers::pi * azimuth / lidar.num_azimuths;
  return {std::cos(elevation) * std::cos(angle), std::cos(elevation) * std::sin(angle), std::sin(elevation)};
}

struct Return {
  double range = std::numeric_limits<double>::infinity();  // metres
  int surface = Sweep::kMoving;
};

// The nearest surface of a scene along a unit direction.
Return nearest_return(const Scene& scene, const Ray& ray) {
  Return nearest;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    const auto hit = intersect(scene.surfaces[i], ray);
    if (hit && hit->distance < nearest.range) nearest = {hit->distance, static_cast<int>(i)};
  }
  return nearest;
}

// Poses at the time of one azimuth.
struct Moment {
  Rigid3 world_from_sensor;
  std::vector<Rigid3> object_from_sensor;
};

Moment moment_of(const World& world, const Motion& world_from_sensor, double time_s) {
  Moment moment{world_from_sensor(time_s), {}};
  for (const MovingObject& object : world.moving)
    moment.object_from_sensor.push_back(inverse(object.world_from_object(time_s)) * moment.world_from_sensor);
  return moment;
}

Ray ray_of(const Rigid3& b_from_sensor, const Vec3d& direction) {
  return {b_from_sensor.translation, b_from_sensor.rotation * direction};
}

Return return_of(const World& world, const Moment& moment, const Vec3d& direction) {
  Return nearest = nearest_return(world.scene, ray_of(moment.world_from_sensor, direction));
  for (std::size_t k = 0; k < world.moving.size(); ++k) {
    const Return of_object = nearest_return(world.moving[k].scene, ray_of(moment.object_from_sensor[k], direction));
    if (of_object.range < nearest.range) nearest = {of_object.range, Sweep::kMoving};
  }
  return nearest;
}

}  // namespace

void Lidar::check() const {
  require(num_rings >= 1, "num_rings", num_rings, "must be at least 1");
  require(num_azimuths >= 1, "num_azimuths", num_azimuths, "must be at least 1");
  require(min_elevation_deg <= max_elevation_deg, "min_elevation_deg", min_elevation_deg,
          "must not be above max_elevation_deg");
  require_not_negative("min_range", min_range);
  require(max_range > min_range, "max_range", max_range, "must be above min_range");
  require_not_negative("range_sigma", range_sigma);
  require_not_negative("sweep_s", sweep_s);
}

Motion moving_evenly(const Rigid3& world_from_body_at_zero, const Rigid3& motion_of_one_second) {
  return [=](double time_s) {
    return world_from_body_at_zero * Rigid3{rotation_exp(time_s * rotation_log(motion_of_one_second.rotation)),
                                            time_s * motion_of_one_second.translation};
  };
}

Sweep scan(const World& world, const Lidar& lidar, const Motion& world_from_sensor, unsigned seed, double begin_s) {
  lidar.check();
  std::mt19937 generator(seed);
  Sweep sweep;
  sweep.cloud.viewpoint = Vec3f::Zero();
  for (int azimuth = 0; azimuth < lidar.num_azimuths; ++azimuth) {
    const double time_s = lidar.sweep_s * azimuth / lidar.num_azimuths;
    const Moment moment = moment_of(world, world_from_sensor, begin_s + time_s);
    for (int ring = 0; ring < lidar.num_rings; ++ring) {
      const Vec3d direction = direction_of(lidar, ring, azimuth);
      const Return seen = return_of(world, moment, direction);
      const double noise = lidar.range_sigma * gaussian(generator);  // drawn for every ray: others keep theirs
      if (!(seen.range >= lidar.min_range && seen.range <= lidar.max_range)) continue;
      sweep.cloud.points.push_back(Vec3d((seen.range + noise) * direction).cast<float>());
      sweep.times_s.push_back(time_s);
      sweep.rings.push_back(ring);
      sweep.surfaces.push_back(seen.surface);
    }
  }
  return sweep;
}

Cloud scan(const Scene& scene, const Lidar& lidar, const Rigid3& world_from_sensor, unsigned seed) {
  return scan({scene, {}}, lidar, standing_at(world_from_sensor), seed).cloud;
}

Cloud straightened(const Sweep& sweep, const Motion& world_from_sensor, double begin_s, double frame_time_s) {
  Cloud cloud;
  const Rigid3 frame_from_world = inverse(world_from_sensor(begin_s + frame_time_s));
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Rigid3 frame_from_sensor = frame_from_world * world_from_sensor(begin_s + sweep.times_s[i]);
    cloud.points.push_back((frame_from_sensor * sweep.cloud.points[i].cast<double>()).cast<float>());
  }
  cloud.viewpoint = Vec3f::Zero();
  return cloud;
}

}  // namespace augicp::synthetic
