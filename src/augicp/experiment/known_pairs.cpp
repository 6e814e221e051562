// SPDX-License-Identifier: MIT
#include "augicp/experiment/known_pairs.h"

#include <numbers>
#include <random>

#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

const Vec3d kHalfSize(5.0, 4.0, 1.5);

struct ExtendedPoint {
  Vec3d point;
  Vec3d direction = Vec3d::Zero();
  Structure structure = Structure::None;
};

double random_sign(std::mt19937& generator) { return generator() & 1u ? 1.0 : -1.0; }

Vec3d inside_room(std::mt19937& generator) {
  const double x = uniform(generator, -1.0, 1.0), y = uniform(generator, -1.0, 1.0);
  return kHalfSize.cwiseProduct(Vec3d(x, y, uniform(generator, -1.0, 1.0)));
}

ExtendedPoint room_point(std::mt19937& generator) {
  const double kind = uniform(generator, 0.0, 1.0);
  const int axis = static_cast<int>(generator() % 3u);
  const double sign = random_sign(generator), other_sign = random_sign(generator);
  ExtendedPoint sample{inside_room(generator)};
  if (kind < 0.7) {
    sample.point[axis] = sign * kHalfSize[axis];
    sample.direction = -sign * Vec3d::Unit(axis);
    sample.structure = Structure::Planar;
  } else if (kind < 0.9) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    sample.point[u] = sign * kHalfSize[u];
    sample.point[v] = other_sign * kHalfSize[v];
    sample.direction = random_sign(generator) * Vec3d::Unit(axis);
    sample.structure = Structure::Edge;
  }
  return sample;
}

Vec3d turned(const Vec3d& direction, double angle_rad, std::mt19937& generator) {
  const Vec3d axis = direction.cross(random_direction(generator)).normalized();
  return rotation_exp(angle_rad * axis) * direction;
}

void append(Cloud& cloud, const ExtendedPoint& sample, const KnownPairsOptions& options, std::mt19937& generator) {
  const double x = gaussian(generator), y = gaussian(generator), z = gaussian(generator);
  cloud.points.push_back((sample.point + options.point_noise_m * Vec3d(x, y, z)).cast<float>());
  const double angle_rad = options.normal_noise_rad * gaussian(generator);
  const bool has_direction = sample.structure != Structure::None;
  const Vec3d direction = has_direction ? turned(sample.direction, angle_rad, generator) : Vec3d(Vec3d::Zero());
  cloud.directions.push_back(direction.cast<float>());
  cloud.structures.push_back(sample.structure);
}

}  // namespace

KnownPairs make_known_pairs(const KnownPairsOptions& options) {
  std::mt19937 generator(options.seed);
  KnownPairs known;
  known.target_from_source = random_motion(generator, std::numbers::pi / 6.0, 1.0);
  const Rigid3 source_from_target = inverse(known.target_from_source);
  for (std::uint32_t i = 0; i < options.num_points; ++i) {
    const ExtendedPoint in_target = room_point(generator);
    const ExtendedPoint in_source{source_from_target * in_target.point,
                                  source_from_target.rotation * in_target.direction, in_target.structure};
    append(known.target, in_target, options, generator);
    append(known.source, in_source, options, generator);
    const bool false_pair = uniform(generator, 0.0, 1.0) < options.outlier_share;
    known.pairs.push_back({i, false_pair ? static_cast<std::uint32_t>(generator() % options.num_points) : i});
  }
  known.target.viewpoint = Vec3f::Zero();
  known.source.viewpoint = source_from_target.translation.cast<float>();
  return known;
}

}  // namespace augicp
