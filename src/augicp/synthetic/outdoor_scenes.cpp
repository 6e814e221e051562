// SPDX-License-Identifier: MIT
#include "augicp/synthetic/outdoor_scenes.h"

#include <cmath>
#include <numbers>

#include "augicp/experiment/random.h"

namespace augicp::synthetic {
namespace {

using testing::Rectangle;
using testing::Scene;

constexpr double kSensorHeight = 1.6;  // metres above the ground, as carried or on a car

Rigid3 sensor_at(const Vec3d& place) { return {Eigen::Quaterniond::Identity(), place}; }

// A strip of the whole length; `across` spans its other side.
Rectangle strip(const Vec3d& offset, const Vec3d& across) {
  return {offset - kHalfLength * Vec3d::UnitX(), 2.0 * kHalfLength * Vec3d::UnitX(), across};
}

testing::Plane level_ground() { return {Vec3d::Zero(), Vec3d::UnitZ()}; }

// What a row of houses draws: widths of 6 to 14 m, gaps on every third place.
void add_houses(Scene& scene, double side, int ground, std::mt19937& generator) {
  constexpr double kRowHalfLength = 80.0, kHalfStreet = 7.0;
  double x = -kRowHalfLength + uniform(generator, 0.0, 5.0);
  while (x < kRowHalfLength) {
    const Vec3d size(uniform(generator, 6.0, 14.0), uniform(generator, 7.0, 12.0), uniform(generator, 4.0, 11.0));
    const double setback = uniform(generator, 0.0, 4.0);
    const Vec3d base(x + 0.5 * size.x(), side * (kHalfStreet + setback + 0.5 * size.y()), 0.0);
    add_standing_box(scene, base, 0.0, size, ground);
    const double gap = uniform(generator, 0.0, 3.0) < 1.0 ? uniform(generator, 2.0, 5.0) : 0.0;
    x += size.x() + gap;
  }
}

// Cars at the kerb and poles behind them, on one side.
void add_street_furniture(Scene& scene, double side, int ground, std::mt19937& generator) {
  for (double x = -50.0; x < 50.0; x += uniform(generator, 6.0, 15.0)) {
    const Vec3d size(uniform(generator, 3.8, 4.8), uniform(generator, 1.6, 1.9), uniform(generator, 1.3, 1.9));
    add_standing_box(scene, {x, side * 4.2, 0.0}, uniform(generator, -0.1, 0.1), size, ground);
    const Vec3d foot(x + uniform(generator, 2.5, 5.0), side * uniform(generator, 5.6, 6.4), 0.0);
    add_wire(scene, foot, foot + uniform(generator, 3.0, 7.0) * Vec3d::UnitZ(), uniform(generator, 0.06, 0.2));
  }
}

}  // namespace

Scene corridor(double width, double height) {
  Scene scene;
  const Vec3d right(0.0, -0.5 * width, 0.0), across(0.0, width, 0.0), up(0.0, 0.0, height);
  add_surface(scene, strip(right, across));
  add_surface(scene, strip(right + up, across));
  add_surface(scene, strip(right, up));
  add_surface(scene, strip(right + across, up));
  scene.world_from_camera = sensor_at({0.0, 0.05 * width, 0.4 * height});
  return scene;
}

Scene tunnel(double radius) {
  Scene scene;
  const double axis_height = 0.5 * radius;
  const double half_floor = std::sqrt(radius * radius - axis_height * axis_height);
  const Vec3d axis(0.0, 0.0, axis_height), half = kHalfLength * Vec3d::UnitX();
  add_surface(scene, testing::Cylinder{axis - half, axis + half, radius});
  add_surface(scene, strip({0.0, -half_floor, 0.0}, {0.0, 2.0 * half_floor, 0.0}));
  scene.world_from_camera = sensor_at({0.0, 0.1 * radius, kSensorHeight});
  return scene;
}

Scene colonnade(double period, double width) {
  constexpr double kHeight = 4.0, kRadius = 0.3;
  Scene scene;
  const Vec3d right(0.0, -0.5 * width - 1.0, 0.0), across(0.0, width + 2.0, 0.0), up(0.0, 0.0, kHeight);
  add_surface(scene, strip(right, across));
  add_surface(scene, strip(right + up, across));
  // Columns farther than any sensor sees would only cost time.
  const int per_side = static_cast<int>(std::ceil(120.0 / period));
  for (int k = -per_side; k <= per_side; ++k)
    for (const double side : {-0.5, 0.5}) {
      const Vec3d foot(k * period, side * width, 0.0);
      add_surface(scene, testing::Cylinder{foot, foot + up, kRadius});
    }
  scene.world_from_camera = sensor_at({0.3 * period, 0.1 * width, kSensorHeight});
  return scene;
}

Scene open_field() {
  Scene scene;
  add_surface(scene, level_ground());
  scene.world_from_camera = sensor_at({0.0, 0.0, kSensorHeight});
  return scene;
}

Scene street(unsigned seed) {
  std::mt19937 generator(seed);
  Scene scene;
  const int ground = add_surface(scene, level_ground());
  for (const double side : {-1.0, 1.0}) {
    add_houses(scene, side, ground, generator);
    add_street_furniture(scene, side, ground, generator);
  }
  scene.world_from_camera = sensor_at({uniform(generator, -10.0, 10.0), uniform(generator, -1.5, 1.5), kSensorHeight});
  return scene;
}

}  // namespace augicp::synthetic
