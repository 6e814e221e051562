// SPDX-License-Identifier: MIT
#include "augicp/synthetic/town.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "augicp/core/check.h"
#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"

namespace augicp::synthetic {
namespace {

constexpr double kRoofSensorHeight = 1.73;  // metres, on a car's roof
constexpr double kCurveRadius = 10.0;       // of the road's centre line
constexpr double kSideRatio = 0.6;          // of the block's short side by its long one
constexpr double kLane = 1.75;              // from the centre line to the middle of a lane
constexpr double kHalfStreet = 7.0;         // from the centre line to the nearest houses
constexpr double kBrakingWay = 15.0;        // before and after a curve
constexpr double kStep = 0.1;               // of the table of times, metres along the road

// The centre line: counterclockwise, from the middle of the first long side, which runs along x.
class Road {
 public:
  explicit Road(double length) : length_(length) {
    const double sides = length + (8.0 - 2.0 * std::numbers::pi) * kCurveRadius;
    long_side_ = 0.5 * sides / (1.0 + kSideRatio);
    short_side_ = kSideRatio * long_side_;
  }

  double length() const { return length_; }
  double side(int k) const { return k % 2 == 0 ? long_side_ : short_side_; }

  // The corner at the begin of side k, if it were not rounded, with x along the side and y to the inside.
  Rigid3 world_from_side(int k) const {
    const std::array<Vec3d, 4> corners{Vec3d(0.0, 0.0, 0.0), Vec3d(long_side_, 0.0, 0.0),
                                       Vec3d(long_side_, short_side_, 0.0), Vec3d(0.0, short_side_, 0.0)};
    return {rotation_exp({0.0, 0.0, 0.5 * std::numbers::pi * k}), corners[static_cast<std::size_t>(k)]};
  }

  // x along the road, y to its left, at a distance along it.
  Rigid3 at(double distance) const {
    double rest = wrapped(distance);
    for (int k = 0; k < 4; ++k) {
      const double straight = side(k) - 2.0 * kCurveRadius;
      if (rest < straight) return world_from_side(k) * along(kCurveRadius + rest);
      rest -= straight;
      if (rest < kCurve) return world_from_side(k) * along(side(k) - kCurveRadius) * curved(rest);
      rest -= kCurve;
    }
    return at(0.0);
  }

  // To the nearest curve; 0 in it.
  double distance_to_curve(double distance) const {
    double rest = wrapped(distance);
    for (int k = 0; k < 4; ++k) {
      const double straight = side(k) - 2.0 * kCurveRadius;
      if (rest < straight) return std::min(rest, straight - rest);
      rest -= straight;
      if (rest < kCurve) return 0.0;
      rest -= kCurve;
    }
    return 0.0;
  }

 private:
  static constexpr double kCurve = 0.5 * std::numbers::pi * kCurveRadius;

  // From the begin of the first side's straight part, for distances of any sign.
  double wrapped(double distance) const {
    const double from_corner = distance + 0.5 * side(0) - kCurveRadius;
    return from_corner - std::floor(from_corner / length_) * length_;
  }
  static Rigid3 along(double distance) { return {Eigen::Quaterniond::Identity(), {distance, 0.0, 0.0}}; }
  static Rigid3 curved(double distance) {
    const double angle = distance / kCurveRadius;
    return {rotation_exp({0.0, 0.0, angle}),
            {kCurveRadius * std::sin(angle), kCurveRadius * (1.0 - std::cos(angle)), 0.0}};
  }

  double length_, long_side_, short_side_;
};

// The distance along the road over time, for a driver who slows down in curves.
class Timetable {
 public:
  Timetable(const Road& road, double speed) : length_(road.length()) {
    const int num_steps = static_cast<int>(std::ceil(length_ / kStep));
    step_ = length_ / num_steps;
    double time_s = 0.0;
    for (int k = 0; k <= num_steps; ++k) {
      times_s_.push_back(time_s);
      const double share = std::min(1.0, road.distance_to_curve((k + 0.5) * step_) / kBrakingWay);
      time_s += step_ / (0.5 * speed * (1.0 + share));
    }
  }

  double lap_s() const { return times_s_.back(); }

  double distance_at(double time_s) const {
    const double laps = std::floor(time_s / lap_s());
    const double rest = time_s - laps * lap_s();
    const auto after = std::upper_bound(times_s_.begin() + 1, times_s_.end() - 1, rest);
    const double begin_s = *(after - 1), share = (rest - begin_s) / (*after - begin_s);
    return laps * length_ + step_ * (static_cast<double>(after - 1 - times_s_.begin()) + share);
  }

 private:
  double length_, step_;
  std::vector<double> times_s_;  // at each step along the road
};

struct Row {
  Rigid3 world_from_row;  // x along the houses, y away from the road; zero on the road's centre line
  double begin, end;      // along x
};

void add_houses(testing::Scene& scene, const Row& row, double yaw_rad, int ground, std::mt19937& generator) {
  for (double x = row.begin; x < row.end;) {
    const Vec3d size(uniform(generator, 6.0, 14.0), uniform(generator, 7.0, 12.0), uniform(generator, 4.0, 11.0));
    const double setback = uniform(generator, 0.0, 4.0);
    const Vec3d base(x + 0.5 * size.x(), kHalfStreet + setback + 0.5 * size.y(), 0.0);
    add_standing_box(scene, row.world_from_row * base, yaw_rad, size, ground);
    x += size.x() + (uniform(generator, 0.0, 3.0) < 1.0 ? uniform(generator, 2.0, 5.0) : 0.0);
  }
}

// Cars at the kerb and poles behind them.
void add_furniture(testing::Scene& scene, const Row& row, double yaw_rad, int ground, std::mt19937& generator) {
  for (double x = row.begin; x < row.end; x += uniform(generator, 6.0, 15.0)) {
    const Vec3d size(uniform(generator, 3.8, 4.8), uniform(generator, 1.6, 1.9), uniform(generator, 1.3, 1.9));
    add_standing_box(scene, row.world_from_row * Vec3d(x, 4.4, 0.0), yaw_rad + uniform(generator, -0.1, 0.1), size,
                     ground);
    const Vec3d foot = row.world_from_row * Vec3d(x + uniform(generator, 2.5, 5.0), uniform(generator, 5.8, 6.5), 0.0);
    add_wire(scene, foot, foot + uniform(generator, 3.0, 7.0) * Vec3d::UnitZ(), uniform(generator, 0.06, 0.2));
  }
}

// Both sides of side k of the block.
void add_side(testing::Scene& scene, const Road& road, int k, int ground, std::mt19937& generator) {
  const Rigid3 inside = road.world_from_side(k);
  const double yaw_rad = 0.5 * std::numbers::pi * k, length = road.side(k);
  const Rigid3 outside =
      inside * Rigid3{rotation_exp({0.0, 0.0, std::numbers::pi}), {length, 0.0, 0.0}};  // the other way along
  add_houses(scene, {inside, kHalfStreet, length - kHalfStreet - 6.0}, yaw_rad, ground, generator);
  add_houses(scene, {outside, -kHalfStreet - 12.0, length + kHalfStreet}, yaw_rad, ground, generator);
  for (const Rigid3& row : {inside, outside})
    add_furniture(scene, {row, kCurveRadius + 4.0, length - kCurveRadius - 4.0}, yaw_rad, ground, generator);
}

Rigid3 beside(double left) { return {Eigen::Quaterniond::Identity(), {0.0, left, 0.0}}; }

// `left` of the road's centre line, at a distance along the road that changes with time.
MovingObject on_road(const Road& road, std::function<double(double)> distance_at, double left, const Vec3d& size) {
  MovingObject object;
  add_box(object.scene, {Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.5 * size.z() + 0.15}}, size);
  object.world_from_object = [=](double time_s) { return road.at(distance_at(time_s)) * beside(left); };
  return object;
}

std::vector<MovingObject> traffic(const Road& road, const std::shared_ptr<const Timetable>& own, double speed,
                                  std::mt19937& generator) {
  constexpr double kSpacing = 40.0;
  std::vector<MovingObject> all;
  all.push_back(on_road(road, [=](double t) { return own->distance_at(t) + 14.0; }, -kLane, {5.5, 2.0, 2.5}));
  for (double begin = 0.0; begin < road.length(); begin += kSpacing) {
    const double oncoming = -0.7 * speed, place = begin + uniform(generator, 0.0, 15.0);
    const Vec3d car(uniform(generator, 3.9, 4.8), uniform(generator, 1.7, 1.9), uniform(generator, 1.3, 1.8));
    all.push_back(on_road(
        road, [=](double t) { return place + oncoming * t; }, kLane, car));
    const double walking = uniform(generator, -1.5, 1.5), left = uniform(generator, 0.0, 1.0) < 0.5 ? -5.3 : 5.3;
    all.push_back(on_road(road, [=](double t) { return place + walking * t; }, left, {0.4, 0.5, 1.6}));
  }
  return all;
}

}  // namespace

void TownOptions::check() const {
  require(length >= 200.0 && length <= 1e5, "length", length, "must be from 200 to 100000");
  require(speed >= 0.1 && speed <= 1000.0, "speed", speed, "must be from 0.1 to 1000");
}

TownLoop town_loop(const TownOptions& options) {
  options.check();
  std::mt19937 generator(options.seed);
  const Road road(options.length);
  const auto timetable = std::make_shared<const Timetable>(road, options.speed);
  TownLoop loop;
  loop.lap_s = timetable->lap_s();
  loop.world_from_sensor = [=](double time_s) {
    const Rigid3 on_roof{Eigen::Quaterniond::Identity(), {0.0, -kLane, kRoofSensorHeight}};
    return road.at(timetable->distance_at(time_s)) * on_roof;
  };
  loop.world.scene.world_from_camera = loop.world_from_sensor(0.0);
  const int ground = add_surface(loop.world.scene, testing::Plane{Vec3d::Zero(), Vec3d::UnitZ()});
  for (int k = 0; k < 4; ++k) add_side(loop.world.scene, road, k, ground, generator);
  if (options.has_traffic) loop.world.moving = traffic(road, timetable, options.speed, generator);
  return loop;
}

}  // namespace augicp::synthetic
