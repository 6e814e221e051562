// SPDX-License-Identifier: MIT
#include "augicp/trust/motion_probe.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "augicp/geometry/rigid3.h"

namespace augicp {
namespace {

// Of each scan.
constexpr std::size_t kNumWitnesses = 2048;

// Points within this many tolerances of the other's say whether they agree.
constexpr double kNearPerTolerance = 3.0;

// A point is surrounded if this many neighbours lie within the radius, on at least so many of eight sides. A scan line
// on a wall has neighbours on two. Round the corner of a corridor it lies in a plane across it, which is no surface,
// and has them on four at most.
constexpr std::size_t kNumNeighbours = 12, kNumNeighboursOnLine = 3;
constexpr std::size_t kNumSides = 8;
constexpr int kMinSides = 5;

// The mean of a point's neighbours is farther from it than this, in distances to the farthest of them, where the points
// end: 4 / (3 pi) at a straight border.
constexpr double kMinOffsetAtBorder = 0.3;

// Of a drawing: its thickness by its extent, squared (that of rounding), and the share of points on lines.
constexpr double kMaxThicknessSq = 1e-10;
constexpr double kMinShareOfLines = 0.9;
constexpr double kMaxPlaceOffPlaneSq = 1e-4;  // of the variance along its longest axis

// A motion is spoken of if the points that it moves off a surface exceed those that it moves onto one by this share of
// all that agree, and by this many deviations of their number. Bare corridors and tunnels stay below 0.011 along their
// axis, with 16 to 128 rings; streets, rooms and objects reach 0.018 in each direction (docs/lab/trust.md).
constexpr double kMinShare = 0.013;
constexpr double kMinDeviations = 4.0;

// A direction holds the pose if a step of a radius loses this share on either side. Of directions that are below the
// loop's limit right poses of objects lose 0.009 and more; poses that had slid along a wall, on the side of the right
// one, 0.0016 at most.
constexpr double kMinShareHeld = 0.005;

constexpr double kSteps[] = {-3.0, -1.0, 1.0, 3.0};  // radii

// The length of a motion: RMS of the points, metres.
double rms_motion(const Cloud& cloud, const Vec6d& motion) {
  double sum_sq = 0.0;
  for (const Vec3f& point : cloud.points)
    sum_sq += (motion.head<3>() + motion.tail<3>().cross(point.cast<double>())).squaredNorm();
  return std::sqrt(sum_sq / static_cast<double>(cloud.size()));
}

Vec3d mean_of(const Cloud& cloud, const std::vector<Neighbour>& points) {
  Vec3d sum = Vec3d::Zero();
  for (const Neighbour& point : points) sum += cloud.points[point.index].cast<double>();
  return sum / static_cast<double>(points.size());
}

Mat3d scatter_of(const Cloud& cloud, const std::vector<Neighbour>& points) {
  const Vec3d mean = mean_of(cloud, points);
  Mat3d scatter = Mat3d::Zero();
  for (const Neighbour& point : points) {
    const Vec3d from_mean = cloud.points[point.index].cast<double>() - mean;
    scatter += from_mean * from_mean.transpose();
  }
  return scatter;
}

// Of kNumSides sectors around a point, in the plane of its neighbours, the number of those that have any.
int num_sides(const Cloud& cloud, std::uint32_t point, const std::vector<Neighbour>& neighbours) {
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(scatter_of(cloud, neighbours));
  std::array<bool, kNumSides> has_any{};
  for (const Neighbour& neighbour : neighbours) {
    if (neighbour.index == point) continue;
    const Vec3d to = (cloud.points[neighbour.index] - cloud.points[point]).cast<double>();
    const double angle = std::atan2(solver.eigenvectors().col(1).dot(to), solver.eigenvectors().col(2).dot(to));
    const double turns = 0.5 + 0.5 * angle / std::numbers::pi;  // [0, 1]
    has_any[std::min<std::size_t>(kNumSides - 1, static_cast<std::size_t>(turns * kNumSides))] = true;
  }
  return static_cast<int>(std::count(has_any.begin(), has_any.end(), true));
}

// Whether all points lie in one plane, and on lines in it: a drawing, or a scan of a single line. Its lines are its
// surface. What a sensor off the plane saw are the scan lines of a field, which move with the sensor.
bool is_drawing_of_lines(const ProbedCloud& probed) {
  const Cloud& cloud = probed.cloud;
  std::vector<Neighbour> all(cloud.size());
  for (std::uint32_t i = 0; i < cloud.size(); ++i) all[i].index = i;
  const Eigen::SelfAdjointEigenSolver<Mat3d> solver(scatter_of(cloud, all));
  const double largest = solver.eigenvalues()[2];
  if (!(solver.eigenvalues()[0] <= kMaxThicknessSq * largest)) return false;
  const auto num_edges = std::count(cloud.structures.begin(), cloud.structures.end(), Structure::Edge);
  if (!(static_cast<double>(num_edges) > kMinShareOfLines * static_cast<double>(cloud.size()))) return false;
  if (!probed.sensor_place) return true;
  const double off_plane = solver.eigenvectors().col(0).dot(probed.sensor_place->cast<double>() - mean_of(cloud, all));
  return off_plane * off_plane * static_cast<double>(cloud.size()) <= kMaxPlaceOffPlaneSq * largest;
}

}  // namespace

MotionProbe::Asked::Asked(const ProbedCloud& of)
    : cloud(of.cloud), tree(of.cloud), is_drawing(is_drawing_of_lines(of)) {}

MotionProbe::MotionProbe(const ProbedCloud& source, const ProbedCloud& target, const AgreementTolerance& tolerance,
                         double radius)
    : tolerance_(tolerance), radius_(radius), source_(source), target_(target) {
  choose_witnesses(source_);
  choose_witnesses(target_);
}

void MotionProbe::choose_witnesses(Asked& scan) const {
  const std::size_t count = std::min(kNumWitnesses, scan.cloud.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto point = static_cast<std::uint32_t>(k * scan.cloud.size() / count);
    if (is_surrounded(scan, point)) scan.witnesses.push_back(point);
  }
}

bool MotionProbe::can_tell() const {
  const std::size_t num_asked =
      std::min(kNumWitnesses, source_.cloud.size()) + std::min(kNumWitnesses, target_.cloud.size());
  return 2 * (source_.witnesses.size() + target_.witnesses.size()) > num_asked;
}

double MotionProbe::allowed(const Vec3f& place) const {
  return tolerance_.distance + tolerance_.per_depth * static_cast<double>(place.norm());
}

bool MotionProbe::is_surrounded(const Asked& scan, std::uint32_t point) const {
  const Vec3f& place = scan.cloud.points[point];
  const std::size_t count = scan.is_drawing ? kNumNeighboursOnLine : kNumNeighbours;
  const std::vector<Neighbour> nearest = scan.tree.nearest_k(place, count);
  const bool is_dense = nearest.size() == count && static_cast<double>(nearest.back().distance_sq) <= radius_ * radius_;
  return is_dense && (scan.is_drawing || num_sides(scan.cloud, point, nearest) >= kMinSides);
}

// Whether a place this far from a point lies on the side where the point has no neighbours.
bool MotionProbe::is_beyond_border(const Asked& scan, std::uint32_t point, const Vec3d& from_point) const {
  if (scan.is_drawing) return false;
  const Vec3f& place = scan.cloud.points[point];
  const std::vector<Neighbour> nearest = scan.tree.nearest_k(place, kNumNeighbours);
  const Vec3d to_mean = mean_of(scan.cloud, nearest) - place.cast<double>();
  const double reach_sq = static_cast<double>(nearest.back().distance_sq);
  return to_mean.squaredNorm() > kMinOffsetAtBorder * kMinOffsetAtBorder * reach_sq && to_mean.dot(from_point) < 0.0;
}

MotionProbe::Answer MotionProbe::answer(const Asked& scan, std::uint32_t point, const Rigid3& other_from_scan,
                                        const Asked& other) const {
  const Vec3d moved = other_from_scan * scan.cloud.points[point].cast<double>();
  const double limit = allowed(moved.cast<float>()), reach = kNearPerTolerance * limit;
  const bool is_planar = scan.cloud.structures[point] == Structure::Planar;
  const Vec3d turned = other_from_scan.rotation * Vec3d(scan.cloud.directions[point].cast<double>());
  const Extended here{moved, is_planar ? std::optional(turned) : std::nullopt, limit};
  // Near a crease the nearest point may be on either side of it.
  Answer answer = Answer::None;
  for (const auto& near : other.tree.nearest_few(moved.cast<float>(), static_cast<float>(reach * reach), {0, 1, 2})) {
    const Answer of_point = near ? answer_of(other, near->index, here) : Answer::None;
    if (of_point == Answer::Agrees) return of_point;
    if (of_point == Answer::Differs) answer = of_point;
  }
  return answer;
}

MotionProbe::Answer MotionProbe::answer_of(const Asked& other, std::uint32_t point, const Extended& here) const {
  const Vec3d error = here.place - other.cloud.points[point].cast<double>();
  if (other.cloud.structures[point] != Structure::Planar) {
    if (!is_surrounded(other, point)) return Answer::None;
    if (error.norm() <= here.allowed) return Answer::Agrees;
    return is_beyond_border(other, point, error) ? Answer::None : Answer::Differs;
  }
  return planar_answer(other, point, here);
}

MotionProbe::Answer MotionProbe::planar_answer(const Asked& other, std::uint32_t point, const Extended& here) const {
  const Vec3d error = here.place - other.cloud.points[point].cast<double>();
  const Vec3d normal = other.cloud.directions[point].cast<double>();
  // Beyond the border of what the other saw its surface is unknown.
  if ((error - normal.dot(error) * normal).norm() > here.allowed) return Answer::None;
  const bool is_on_plane = std::abs(normal.dot(error)) <= here.allowed;
  const bool is_parallel = !here.normal || std::abs(normal.dot(*here.normal)) >= tolerance_.min_cosine;
  return is_on_plane && is_parallel ? Answer::Agrees : Answer::Differs;
}

std::vector<MotionProbe::Answer> MotionProbe::answers(const Rigid3& target_from_source) const {
  const Rigid3 source_from_target = inverse(target_from_source);
  std::vector<Answer> all;
  for (const std::uint32_t point : source_.witnesses)
    all.push_back(answer(source_, point, target_from_source, target_));
  for (const std::uint32_t point : target_.witnesses)
    all.push_back(answer(target_, point, source_from_target, source_));
  return all;
}

MotionProbe::Change MotionProbe::change(std::span<const Answer> before, std::span<const Answer> after) {
  Change change;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k] == Answer::None || after[k] == Answer::None) continue;
    change.agreeing += before[k] == Answer::Agrees;
    change.lost += before[k] == Answer::Agrees && after[k] == Answer::Differs;
    change.gained += before[k] == Answer::Differs && after[k] == Answer::Agrees;
  }
  return change;
}

// 1: clearly more points agree afterwards; -1: fewer.
int MotionProbe::clear_change(const Change& change) {
  const auto net = static_cast<double>(std::abs(change.gained - change.lost));
  const bool is_clear = net > kMinShare * static_cast<double>(change.agreeing) &&
                        net > kMinDeviations * std::sqrt(static_cast<double>(change.lost + change.gained));
  return !is_clear ? 0 : change.gained > change.lost ? 1 : -1;
}

int MotionProbe::compared(const Rigid3& target_from_source, const Rigid3& with_target_from_source) const {
  return clear_change(change(answers(with_target_from_source), answers(target_from_source)));
}

Vec6d MotionProbe::of_a_radius(const Vec6d& direction) const {
  return radius_ / rms_motion(target_.cloud, direction) * direction;
}

std::vector<bool> MotionProbe::spoken_of(const Rigid3& target_from_source, std::span<const Vec6d> directions) const {
  const std::vector<Answer> before = answers(target_from_source);
  std::vector<bool> is_spoken_of;
  for (const Vec6d& direction : directions)
    is_spoken_of.push_back(std::any_of(std::begin(kSteps), std::end(kSteps), [&](double radii) {
      const Rigid3 moved = retract(target_from_source, radii * of_a_radius(direction));
      return clear_change(change(before, answers(moved))) != 0;
    }));
  return is_spoken_of;
}

std::vector<bool> MotionProbe::held_along(const Rigid3& target_from_source, std::span<const Vec6d> directions) const {
  const std::vector<Answer> before = answers(target_from_source);
  std::vector<bool> is_held;
  for (const Vec6d& direction : directions) {
    const auto loses = [&](double radii) {
      const Change by_step = change(before, answers(retract(target_from_source, radii * of_a_radius(direction))));
      return static_cast<double>(by_step.lost - by_step.gained) > kMinShareHeld * static_cast<double>(by_step.agreeing);
    };
    is_held.push_back(loses(1.0) && loses(-1.0));
  }
  return is_held;
}

}  // namespace augicp
