// SPDX-License-Identifier: MIT
#include "augicp/testing/degenerate_families.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "augicp/testing/poses.h"

namespace augicp::testing {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kNoise = 0.002;

Vec6d along(const Vec3d& axis) { return (Vec6d() << axis, Vec3d::Zero()).finished(); }
Vec6d about(const Vec3d& axis) { return (Vec6d() << Vec3d::Zero(), axis).finished(); }
Vec6d screw(const Vec3d& axis, double pitch) { return (Vec6d() << pitch * axis, axis).finished(); }

const Vec3d kX = Vec3d::UnitX(), kY = Vec3d::UnitY(), kZ = Vec3d::UnitZ();

using Generator = std::mt19937;

double side(Generator& generator, double half) { return uniform(generator, -half, half); }

// A profile (radius, height) turned about the z axis.
Vec3d turned(Generator& generator, double radius, double height) {
  const double angle = uniform(generator, 0.0, kTwoPi);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

// Walls at x = -1 and 1, floor and ceiling at z = -1 and 1, running along y.
Vec3d corridor_point(Generator& generator) {
  const double a = side(generator, 1.0), y = side(generator, 2.5);
  switch (generator() % 4) {
    case 0:
      return {-1.0, y, a};
    case 1:
      return {1.0, y, a};
    case 2:
      return {a, y, -1.0};
    default:
      return {a, y, 1.0};
  }
}

// Six steps of 30 by 20 cm, running along y.
Vec3d step_point(Generator& generator) {
  const double tread = 0.3, rise = 0.2, y = side(generator, 1.0);
  const double step = static_cast<double>(generator() % 6);
  if (generator() % 5 < 3) return {step * tread + uniform(generator, 0.0, tread), y, step * rise};
  return {step * tread, y, (step - 1.0) * rise + uniform(generator, 0.0, rise)};
}

Vec3d vase_point(Generator& generator) {
  const double height = side(generator, 0.8);
  return turned(generator, 0.4 + 0.15 * std::sin(4.0 * height), height);
}

// Two walls that lean on each other, running along y.
Vec3d trough_point(Generator& generator) {
  const double a = uniform(generator, 0.0, 1.0), y = side(generator, 1.5);
  return generator() % 2 == 0 ? Vec3d(a, y, a) : Vec3d(-a, y, a);
}

constexpr double kRampPitch = 0.15;  // metres a radian
Vec3d ramp_point(Generator& generator) {
  const double angle = uniform(generator, -kTwoPi, kTwoPi), radius = uniform(generator, 0.3, 1.0);
  return {radius * std::cos(angle), radius * std::sin(angle), kRampPitch * angle};
}

Vec3d plane_point(Generator& generator) { return {side(generator, 1.0), side(generator, 1.0), 0.0}; }

// Bumps of half the noise.
Vec3d bumpy_point(Generator& generator) {
  const Vec3d flat = plane_point(generator);
  return flat + 0.5 * kNoise * std::sin(9.0 * flat.x()) * std::sin(7.0 * flat.y()) * kZ;
}

Vec3d planes_point(Generator& generator) { return plane_point(generator) + (generator() % 2 == 0 ? 0.0 : 0.6) * kZ; }

}  // namespace

std::vector<DegenerateFamily> degenerate_families() {
  const std::vector<Vec6d> of_plane{along(kX), along(kY), about(kZ)};
  return {{"plane", plane_point, of_plane, kNoise},
          {"plane with faint bumps", bumpy_point, of_plane, kNoise},
          {"two parallel planes", planes_point, of_plane, kNoise},
          {"corridor", corridor_point, {along(kY)}, kNoise},
          {"steps", step_point, {along(kY)}, kNoise},
          {"cylinder", [](Generator& g) { return turned(g, 0.5, side(g, 1.0)); }, {along(kZ), about(kZ)}, kNoise},
          {"sphere",
           [](Generator& g) { return Vec3d(0.7 * random_direction(g)); },
           {about(kX), about(kY), about(kZ)},
           kNoise},
          {"cone",
           [](Generator& g) {
             const double radius = std::sqrt(uniform(g, 0.04, 1.0));
             return turned(g, radius, -radius);
           },
           {about(kZ)},
           kNoise},
          {"vase", vase_point, {about(kZ)}, kNoise},
          {"wire", [](Generator& g) { return Vec3d(0.0, side(g, 1.5), 0.0); }, {along(kY), about(kY)}, kNoise},
          {"trough", trough_point, {along(kY)}, kNoise},
          {"spiral ramp", ramp_point, {screw(kZ, kRampPitch)}, kNoise}};
}

Cloud draw(const DegenerateFamily& family, std::size_t count, double noise, std::mt19937& generator) {
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d error(gaussian(generator), gaussian(generator), gaussian(generator));
    cloud.points.push_back((family.draw_point(generator) + noise * error).cast<float>());
  }
  return cloud;
}

namespace {

// About the centroid, in metres.
Vec6d in_metres(const Vec6d& motion, double gyration, const Vec3d& centroid) {
  Vec6d moved = motion;
  moved.head<3>() += motion.tail<3>().cross(centroid);
  moved.tail<3>() *= gyration;
  return moved;
}

// What is left of a motion, given so, without its part in the family's space.
Vec6d without_free(const DegenerateFamily& family, const Vec6d& motion_in_metres, double gyration,
                   const Vec3d& centroid) {
  Eigen::MatrixXd basis(6, static_cast<Eigen::Index>(family.free_motions.size()));
  for (Eigen::Index k = 0; k < basis.cols(); ++k)
    basis.col(k) = in_metres(family.free_motions[static_cast<std::size_t>(k)], gyration, centroid);
  const Eigen::HouseholderQR<Eigen::MatrixXd> decomposition(basis);
  const Eigen::MatrixXd orthonormal = decomposition.householderQ() * Eigen::MatrixXd::Identity(6, basis.cols());
  return motion_in_metres - orthonormal * (orthonormal.transpose() * motion_in_metres);
}

}  // namespace

double angle_to_free(const DegenerateFamily& family, const std::vector<Vec6d>& found, double gyration,
                     const Vec3d& centroid) {
  double largest = 0.0;
  for (const Vec6d& motion : found) {
    const Vec6d unit = in_metres(motion, gyration, centroid).normalized();
    largest = std::max(largest, std::asin(std::min(1.0, without_free(family, unit, gyration, centroid).norm())));
  }
  return largest;
}

double held_part(const DegenerateFamily& family, const Vec6d& motion, double gyration, const Vec3d& centroid) {
  return without_free(family, in_metres(motion, gyration, centroid), gyration, centroid).norm();
}

}  // namespace augicp::testing
