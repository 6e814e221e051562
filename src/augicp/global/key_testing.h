// SPDX-License-Identifier: MIT
// Key clouds and pairs for the tests of this module.
#pragma once

#include <random>

#include "augicp/cloud/correspondence.h"
#include "augicp/global/descriptors.h"
#include "augicp/synthetic/objects.h"
#include "augicp/testing/poses.h"

namespace augicp {

inline KeyCloud key_cloud_of_a_chair(unsigned seed, const std::optional<Vec3f>& viewpoint = std::nullopt) {
  std::mt19937 generator(seed);
  const Cloud chair = synthetic::sampled(synthetic::objects().front(), 20000, 0.0005, generator);
  return key_cloud(chair, 0.02, viewpoint, 1);
}

// The same points in another frame.
inline KeyCloud moved(KeyCloud cloud, const Rigid3& b_from_a) {
  const Rigid3f moves(b_from_a);
  for (Vec3f& point : cloud.points) point = moves * point;
  for (Vec3f& normal : cloud.normals) normal = moves.rotation * normal;
  if (cloud.viewpoint) cloud.viewpoint = moves * *cloud.viewpoint;
  return cloud;
}

// Key points at random, without descriptors, and the same moved, with `num_false` random pairs before the true ones.
struct KnownKeys {
  KeyPoints source, target;
  std::vector<Correspondence> pairs;
  Rigid3 target_from_source;
};

inline KnownKeys known_keys(std::size_t num_true, std::size_t num_false, unsigned seed) {
  std::mt19937 generator(seed);
  KnownKeys keys;
  keys.target_from_source = testing::random_motion(generator, 2.0, 3.0);
  const Rigid3f moves(keys.target_from_source);
  const auto place = [&] {
    return Vec3f(Vec3d::NullaryExpr([&](int) { return testing::uniform(generator, -1.0, 1.0); }).cast<float>());
  };
  for (std::size_t k = 0; k < num_true + num_false; ++k) {
    keys.source.points.push_back(place());
    keys.source.normals.push_back(testing::random_direction(generator).cast<float>());
    keys.target.points.push_back(moves * keys.source.points.back());
    keys.target.normals.push_back(moves.rotation * keys.source.normals.back());
  }
  const auto any = [&] { return static_cast<std::uint32_t>(generator() % (num_true + num_false)); };
  for (std::size_t k = 0; k < num_false; ++k) keys.pairs.push_back({any(), any()});
  for (std::uint32_t k = 0; k < num_true; ++k) keys.pairs.push_back({k, k});
  return keys;
}

}  // namespace augicp
