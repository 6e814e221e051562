// SPDX-License-Identifier: MIT
#include "augicp/shutter/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

// Pieces of the points' order whose mean azimuths are compared. A piece is a few degrees of a revolution.
constexpr std::size_t kNumPieces = 64;

// Length of the mean of a piece's unit vectors: of points within 50 degrees it is above 0.9; all around it is near 0.
// In all but a few pieces (empty sky lets the azimuth leap) it must be above this.
constexpr double kMinConcentration = 0.9;
constexpr std::size_t kMaxScatteredPieces = 6;

// A sweep of less than this is no spinning sensor's, radians.
constexpr double kMinSpan = 1.5 * std::numbers::pi;

// Spinning sensors look around, within some 30 degrees of the horizon: of nearly all points the elevation is below
// this.
constexpr double kMaxSlope = 1.2;  // tangent of 50 degrees
constexpr double kMaxShareAbove = 0.03;

bool looks_around(const Cloud& cloud) {
  std::size_t num_above = 0;
  for (const Vec3f& point : cloud.points) {
    const Vec3d p = cloud.origin + point.cast<double>();
    if (std::abs(p.z()) > kMaxSlope * p.head<2>().norm()) ++num_above;
  }
  return static_cast<double>(num_above) <= kMaxShareAbove * static_cast<double>(cloud.size());
}

double azimuth_of(const Cloud& cloud, std::size_t i) {
  const Vec3d p = cloud.origin + cloud.points[i].cast<double>();
  return std::atan2(p.y(), p.x());
}

double nearest_turn(double angle, double to) { return to + std::remainder(angle - to, 2.0 * std::numbers::pi); }

// The mean azimuth of each piece, without leaps of a whole turn; empty where the order is not that of a sweep.
std::vector<double> piece_azimuths(const std::vector<double>& azimuths) {
  std::vector<double> of_piece;
  std::size_t num_scattered = 0;
  for (std::size_t piece = 0; piece < kNumPieces; ++piece) {
    const std::size_t begin = piece * azimuths.size() / kNumPieces, end = (piece + 1) * azimuths.size() / kNumPieces;
    double x = 0.0, y = 0.0;
    for (std::size_t i = begin; i < end; ++i) x += std::cos(azimuths[i]), y += std::sin(azimuths[i]);
    if (std::sqrt(x * x + y * y) < kMinConcentration * static_cast<double>(end - begin)) ++num_scattered;
    const double mean = std::atan2(y, x);
    of_piece.push_back(of_piece.empty() ? mean : nearest_turn(mean, of_piece.back()));
  }
  if (num_scattered > kMaxScatteredPieces) return {};
  const double sign = of_piece.back() > of_piece.front() ? 1.0 : -1.0;
  for (double& azimuth : of_piece) azimuth *= sign;
  const bool advances = std::is_sorted(of_piece.begin(), of_piece.end());
  if (!advances || of_piece.back() - of_piece.front() < kMinSpan) return {};
  for (double& azimuth : of_piece) azimuth *= sign;
  return of_piece;
}

SweepShares shares_between(const std::vector<double>& values, double first, double last) {
  SweepShares shares;
  shares.reserve(values.size());
  for (const double value : values)
    shares.push_back(static_cast<float>(std::clamp((value - first) / (last - first), 0.0, 1.0)));
  return shares;
}

// Between two poses.
struct MeanRates {
  Vec3d velocity_in_world;  // metres per second
  Vec3d rotation;           // radians per second, in the sensor's frame
};

MeanRates mean_rates(const StampedPose& first, const StampedPose& second) {
  const Rigid3 &from = first.world_from_camera, &to = second.world_from_camera;
  const double passed_s = second.stamp_s - first.stamp_s;
  return {(to.translation - from.translation) / passed_s,
          rotation_log(from.rotation.conjugate() * to.rotation) / passed_s};
}

// Each point by the motion of its share, which is looked up in a table: between two entries the sensor has moved by
// less than a thousandth of the sweep's motion.
template <typename MotionAt>
Cloud moved_by_shares(const Cloud& cloud, const SweepShares& shares, int num_threads, const MotionAt& motion_at) {
  if (shares.empty()) return cloud;
  require(shares.size() == cloud.size(), "shares", static_cast<double>(shares.size()), "must be one a point");
  constexpr std::size_t kNumPoses = 1024;
  std::array<Eigen::Matrix3f, kNumPoses> rotations;
  std::array<Vec3f, kNumPoses> translations;
  for (std::size_t k = 0; k < kNumPoses; ++k) {
    const Rigid3 motion = motion_at((static_cast<double>(k) + 0.5) / kNumPoses);
    rotations[k] = motion.rotation.toRotationMatrix().cast<float>();
    translations[k] = (motion * cloud.origin - cloud.origin).cast<float>();
  }
  Cloud moved = cloud;
  for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto k = std::min(static_cast<std::size_t>(shares[i] * kNumPoses), kNumPoses - 1);
      moved.points[i] = rotations[k] * cloud.points[i] + translations[k];
      if (cloud.has_directions()) moved.directions[i] = rotations[k] * cloud.directions[i];
    }
  });
  return moved;
}

}  // namespace

SweepShares shares_from_times(std::span<const double> times) {
  for (const double time : times) require(std::isfinite(time), "time", time, "must be finite");
  const auto [first, last] = std::minmax_element(times.begin(), times.end());
  if (times.empty() || *first == *last) return {};
  return shares_between({times.begin(), times.end()}, *first, *last);
}

std::optional<double> likely_time_unit_s(double duration_in_unit, double expected_s) {
  constexpr double kMaxRatio = 30.0;  // units are a factor of 1000 apart
  for (const double unit_s : {1.0, 1e-3, 1e-6, 1e-9}) {
    const double ratio = duration_in_unit * unit_s / expected_s;
    if (ratio > 1.0 / kMaxRatio && ratio < kMaxRatio) return unit_s;
  }
  return std::nullopt;
}

SweepShares shares_from_order(const Cloud& cloud) {
  const std::size_t count = cloud.size();
  if (count < 8 * kNumPieces || !looks_around(cloud)) return {};
  std::vector<double> azimuths(count);
  for (std::size_t i = 0; i < count; ++i) azimuths[i] = azimuth_of(cloud, i);
  const std::vector<double> of_piece = piece_azimuths(azimuths);
  if (of_piece.empty()) return {};
  const double points_per_piece = static_cast<double>(count) / kNumPieces;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / points_per_piece - 0.5;
    const auto piece = static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(kNumPieces - 2)));
    const double expected =
        of_piece[piece] + (place - static_cast<double>(piece)) * (of_piece[piece + 1] - of_piece[piece]);
    azimuths[i] = nearest_turn(azimuths[i], expected);
  }
  // Half a piece before the first one's mean the sweep began; single points lie beyond.
  const double before = 0.5 * (of_piece[1] - of_piece[0]);
  const double after = 0.5 * (of_piece[kNumPieces - 1] - of_piece[kNumPieces - 2]);
  return shares_between(azimuths, of_piece.front() - before, of_piece.back() + after);
}

SweepShares shares_from_azimuth(const Cloud& cloud) {
  SweepShares shares(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    shares[i] = static_cast<float>(0.5 * (1.0 - azimuth_of(cloud, i) / std::numbers::pi));
  return shares;
}

Rigid3 SweepMotion::middle_from(double share) const {
  const double since_middle = share - 0.5, half_sq = 0.5 * since_middle * since_middle;
  return {rotation_exp(since_middle * rotation + half_sq * angular_acceleration),
          since_middle * velocity + half_sq * acceleration};
}

SweepMotion motion_of_last(const std::optional<StampedPose>& before_last, const StampedPose& last,
                           const StampedPose& now, double sweep_s) {
  const MeanRates rates = mean_rates(last, now);
  const double passed_s = now.stamp_s - last.stamp_s;
  Vec3d acceleration, angular_acceleration = Vec3d::Zero();
  if (before_last) {
    const MeanRates earlier = mean_rates(*before_last, last);
    const double between_means_s = 0.5 * (now.stamp_s - before_last->stamp_s);
    acceleration = (rates.velocity_in_world - earlier.velocity_in_world) / between_means_s;
    angular_acceleration = (rates.rotation - earlier.rotation) / between_means_s;
  } else {
    const Eigen::Quaterniond& from = last.world_from_camera.rotation;
    const Eigen::Quaterniond halfway = from * rotation_exp(0.5 * passed_s * rates.rotation);
    acceleration = (halfway * rates.rotation).cross(rates.velocity_in_world);
  }
  const Eigen::Quaterniond now_from_world = now.world_from_camera.rotation.conjugate();
  SweepMotion motion;  // the means are those of half of passed_s ago
  motion.velocity = now_from_world * Vec3d(rates.velocity_in_world + 0.5 * passed_s * acceleration) * sweep_s;
  motion.acceleration = now_from_world * acceleration * (sweep_s * sweep_s);
  motion.rotation = (rates.rotation + 0.5 * passed_s * angular_acceleration) * sweep_s;
  motion.angular_acceleration = angular_acceleration * (sweep_s * sweep_s);
  return motion;
}

SweepMotion later_by(double sweeps, const SweepMotion& motion) {
  const Eigen::Quaterniond later_from_now = motion.middle_from(0.5 + sweeps).rotation.conjugate();
  SweepMotion later = motion;
  later.velocity = later_from_now * Vec3d(motion.velocity + sweeps * motion.acceleration);
  later.acceleration = later_from_now * motion.acceleration;
  later.rotation = motion.rotation + sweeps * motion.angular_acceleration;
  return later;
}

Cloud without_skew(const Cloud& cloud, const SweepShares& shares, const SweepMotion& motion, int num_threads) {
  return moved_by_shares(cloud, shares, num_threads, [&](double share) { return motion.middle_from(share); });
}

Cloud straightened_again(const Cloud& straight, const SweepShares& shares, const SweepMotion& before,
                         const SweepMotion& motion, int num_threads) {
  return moved_by_shares(straight, shares, num_threads,
                         [&](double share) { return motion.middle_from(share) * inverse(before.middle_from(share)); });
}

}  // namespace augicp
