// SPDX-License-Identifier: MIT
#include "augicp/synthetic/lidar.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "augicp/core/angles.h"
#include "augicp/core/check.h"
#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"

namespace augicp::synthetic {
namespace {

using testing::Ray;
using testing::Scene;

double azimuth_of(const Lidar& lidar, int azimuth) { return 2.0 * std::numbers::pi * azimuth / lidar.num_azimuths; }

Vec3d direction_of(const Lidar& lidar, int ring, int azimuth) {
  const double step_deg =
      lidar.num_rings > 1 ? (lidar.max_elevation_deg - lidar.min_elevation_deg) / (lidar.num_rings - 1) : 0.0;
  const double elevation = (lidar.min_elevation_deg + ring * step_deg) * kRadPerDeg;
  const double angle = azimuth_of(lidar, azimuth);
  return {std::cos(elevation) * std::cos(angle), std::cos(elevation) * std::sin(angle), std::sin(elevation)};
}

struct Return {
  double range = std::numeric_limits<double>::infinity();  // metres
  int surface = Sweep::kMoving;
};

// A ball that contains a surface.
struct Ball {
  Vec3d centre = Vec3d::Zero();
  double radius = std::numeric_limits<double>::infinity();
};

Ball ball_around(const testing::Surface& surface) {
  if (const auto* rectangle = std::get_if<testing::Rectangle>(&surface)) {
    const Vec3d diagonal = rectangle->side_u + rectangle->side_v;
    return {rectangle->corner + 0.5 * diagonal, 0.5 * diagonal.norm()};
  }
  if (const auto* sphere = std::get_if<testing::Sphere>(&surface)) return {sphere->center, sphere->radius};
  if (const auto* cylinder = std::get_if<testing::Cylinder>(&surface)) {
    const Vec3d axis = cylinder->end - cylinder->begin;
    return {cylinder->begin + 0.5 * axis, 0.5 * axis.norm() + cylinder->radius};
  }
  return {};
}

// A scene, and the surfaces that the rays of one azimuth may meet: these rays lie in a half-plane.
class Seen {
 public:
  explicit Seen(const Scene& scene) : scene_(scene) {
    for (const testing::Surface& surface : scene.surfaces) balls_.push_back(ball_around(surface));
  }

  // ahead, across: unit vectors in the half-plane and normal to it.
  void look(const Vec3d& origin, const Vec3d& ahead, const Vec3d& across) {
    candidates_.clear();
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const Vec3d to = balls_[i].centre - origin;
      if (std::abs(across.dot(to)) <= balls_[i].radius && ahead.dot(to) >= -balls_[i].radius) candidates_.push_back(i);
    }
  }

  // The nearest surface along a unit direction in the half-plane.
  Return nearest(const Ray& ray) const {
    Return nearest;
    for (const std::size_t i : candidates_) {
      const auto hit = intersect(scene_.surfaces[i], ray);
      if (hit && hit->distance < nearest.range) nearest = {hit->distance, static_cast<int>(i)};
    }
    return nearest;
  }

 private:
  const Scene& scene_;
  std::vector<Ball> balls_;
  std::vector<std::size_t> candidates_;
};

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

// A world as it is seen along one azimuth.
class SeenWorld {
 public:
  explicit SeenWorld(const World& world) : scene_(world.scene) {
    for (const MovingObject& object : world.moving) objects_.emplace_back(object.scene);
  }

  void look(const Moment& moment, double azimuth_rad) {
    const Vec3d ahead(std::cos(azimuth_rad), std::sin(azimuth_rad), 0.0);
    const Vec3d across(-ahead.y(), ahead.x(), 0.0);
    const auto look_at = [&](Seen& seen, const Rigid3& pose) {
      seen.look(pose.translation, pose.rotation * ahead, pose.rotation * across);
    };
    look_at(scene_, moment.world_from_sensor);
    for (std::size_t k = 0; k < objects_.size(); ++k) look_at(objects_[k], moment.object_from_sensor[k]);
  }

  Return along(const Moment& moment, const Vec3d& direction) const {
    Return nearest = scene_.nearest(ray_of(moment.world_from_sensor, direction));
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      const Return of_object = objects_[k].nearest(ray_of(moment.object_from_sensor[k], direction));
      if (of_object.range < nearest.range) nearest = {of_object.range, Sweep::kMoving};
    }
    return nearest;
  }

 private:
  Seen scene_;
  std::vector<Seen> objects_;
};

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
  SeenWorld seen_world(world);
  Sweep sweep;
  sweep.cloud.viewpoint = Vec3f::Zero();
  for (int azimuth = 0; azimuth < lidar.num_azimuths; ++azimuth) {
    const double time_s = lidar.sweep_s * azimuth / lidar.num_azimuths;
    const Moment moment = moment_of(world, world_from_sensor, begin_s + time_s);
    seen_world.look(moment, azimuth_of(lidar, azimuth));
    for (int ring = 0; ring < lidar.num_rings; ++ring) {
      const Vec3d direction = direction_of(lidar, ring, azimuth);
      const Return seen = seen_world.along(moment, direction);
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

std::vector<float> reflectivities(const Sweep& sweep) {
  constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples, modulo 1, are spread evenly
  std::vector<float> all;
  for (const int surface : sweep.surfaces) {
    const double number = kGoldenRatio * surface;
    all.push_back(surface == Sweep::kMoving ? 1.0f : static_cast<float>(0.1 + 0.8 * (number - std::floor(number))));
  }
  return all;
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
