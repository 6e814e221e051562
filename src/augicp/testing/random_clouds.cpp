// SPDX-License-Identifier: MIT
#include "augicp/testing/random_clouds.h"

#include <random>

#include "augicp/testing/poses.h"

namespace augicp::testing {

Cloud random_points(std::size_t count, double half_extent_m, unsigned seed) {
  std::mt19937 generator(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = uniform(generator, -half_extent_m, half_extent_m),
                 y = uniform(generator, -half_extent_m, half_extent_m);
    cloud.points.push_back(Vec3d(x, y, uniform(generator, -half_extent_m, half_extent_m)).cast<float>());
  }
  return cloud;
}

namespace {

// Its mean is near the point; its information is from 1 to 1000 along random axes.
PointGaussian random_gaussian(const Vec3f& point, std::mt19937& generator) {
  const Mat3d axes = random_motion(generator, 2.0, 0.0).rotation.toRotationMatrix();
  const double weak = uniform(generator, 1.0, 10.0), middle = uniform(generator, 1.0, 100.0);
  const Vec3d information(weak, middle, uniform(generator, 100.0, 1000.0));
  const Mat3d matrix = axes * information.asDiagonal() * axes.transpose();
  return {point + 0.1f * random_direction(generator).cast<float>(), matrix.cast<float>()};
}

}  // namespace

Cloud random_extended_points(std::size_t count, double half_extent_m, unsigned seed) {
  Cloud cloud = random_points(count, half_extent_m, seed);
  std::mt19937 generator(seed + 1000u), of_gaussians(seed + 2000u);
  for (std::size_t i = 0; i < count; ++i) {
    const auto structure = static_cast<Structure>(i % 3);
    const Vec3d direction = random_direction(generator);
    cloud.directions.push_back(structure == Structure::None ? Vec3f::Zero() : Vec3f(direction.cast<float>()));
    cloud.structures.push_back(structure);
    cloud.weights.push_back(static_cast<float>(uniform(generator, 0.1, 1.0)));
    cloud.gaussians.push_back(random_gaussian(cloud.points[i], of_gaussians));
  }
  cloud.viewpoint = random_direction(generator).cast<float>();
  return cloud;
}

std::vector<Correspondence> random_pairs(std::size_t num_pairs, std::size_t num_points, unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<Correspondence> pairs;
  for (std::size_t k = 0; k < num_pairs; ++k) {
    const auto source = static_cast<std::uint32_t>(generator() % num_points);
    pairs.push_back({source, static_cast<std::uint32_t>(generator() % num_points)});
  }
  return pairs;
}

}  // namespace augicp::testing
