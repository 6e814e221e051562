// SPDX-License-Identifier: MIT
#include "augicp/odometry/local_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

const MergeOptions kMerge;

// The view of a noisy camera on a room from near the scene's own place, with its surface.
Scan seen_from(const Rigid3& scene_camera_from_camera, unsigned noise_seed, const RegistrationOptions& options = {}) {
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(80);
  DepthImage depth =
      testing::render(room, camera, camera.width, camera.height, room.world_from_camera * scene_camera_from_camera)
          .depth;
  if (noise_seed > 0) testing::add_depth_noise(depth, testing::kKinectSigmaAt1m, noise_seed);
  const Scan scan = scan_of(depth, camera);
  return prepare(scan, derive_lengths(scan, scan), options);
}

// The median distance of a's points from the planes that b saw in the same pixels.
double median_distance(const Scan& a, const Scan& b) {
  std::vector<double> distances;
  for (std::size_t pixel = 0; pixel < a.view->index.index.size(); ++pixel) {
    const std::int32_t i = a.view->index.index[pixel], j = b.view->index.index[pixel];
    if (i == IndexImage::kNone || j == IndexImage::kNone || b.cloud.structures[j] != Structure::Planar) continue;
    distances.push_back(std::abs(b.cloud.directions[j].dot(a.cloud.points[i] - b.cloud.points[j])));
  }
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2];
}

TEST(LocalModel, OfOneFrameIsThatFrame) {
  const Scan frame = seen_from({}, 1);
  const LocalModel model = model_of(frame);
  EXPECT_EQ(model.scan.cloud.points, frame.cloud.points);
  EXPECT_EQ(model.weights, frame.cloud.weights);
}

TEST(LocalModel, FramesWithoutWeightsCountAlike) {
  Scan frame = seen_from({}, 1), other = seen_from({}, 2);
  frame.cloud.weights.clear();
  other.cloud.weights.clear();
  LocalModel model = model_of(frame);
  merge(model, other, Rigid3{}, kMerge, 1);
  std::size_t num_averaged = 0;
  for (const float weight : model.weights) num_averaged += weight == 2.0f;
  EXPECT_GT(num_averaged, frame.cloud.size() / 2);
  EXPECT_EQ(carried_over(model, other, Rigid3{}, kMerge, 1).scan.cloud.weights.size(), frame.cloud.size());
}

TEST(LocalModel, AveragesNoiseAway) {
  const Scan exact = seen_from({}, 0);
  LocalModel model = model_of(seen_from({}, 1));
  const double alone = median_distance(model.scan, exact);
  for (unsigned seed = 2; seed <= 16; ++seed) merge(model, seen_from({}, seed), Rigid3{}, kMerge, 1);
  // 16 independent readings: a quarter, were all of them merged.
  EXPECT_LT(median_distance(model.scan, exact), 0.45 * alone);
}

TEST(LocalModel, AlsoOverFramesFromOtherPlaces) {
  const Scan exact = seen_from({}, 0);
  LocalModel model = model_of(seen_from({}, 1));
  const double alone = median_distance(model.scan, exact);
  for (unsigned seed = 2; seed <= 10; ++seed) {
    const Rigid3 moved{rotation_exp({0.0, 0.003 * seed, 0.0}), {0.004 * seed, 0.0, 0.0}};
    merge(model, seen_from(moved, seed), moved, kMerge, 1);
  }
  EXPECT_LT(median_distance(model.scan, exact), 0.7 * alone);
}

TEST(LocalModel, ReadingsFarOffOrTurnedAreNotAveraged) {
  const Scan frame = seen_from({}, 0);
  for (const Rigid3& wrong : {Rigid3{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.2}}}) {
    LocalModel model = model_of(frame);
    merge(model, frame, wrong, kMerge, 1);
    const std::vector<Vec3f> old(model.scan.cloud.points.begin(), model.scan.cloud.points.begin() + frame.cloud.size());
    std::size_t num_kept = 0;
    for (std::size_t i = 0; i < old.size(); ++i) num_kept += old[i] == frame.cloud.points[i];
    EXPECT_GT(num_kept, old.size() * 9 / 10);
  }
  Scan turned = frame;
  for (Vec3f& direction : turned.cloud.directions) direction = direction.unitOrthogonal();
  LocalModel model = model_of(frame);
  merge(model, turned, Rigid3{}, kMerge, 1);
  for (std::size_t i = 0; i < frame.cloud.size(); ++i) {
    if (frame.cloud.structures[i] != Structure::None) {
      EXPECT_EQ(model.weights[i], frame.cloud.weights[i]);
    }
  }
}

TEST(LocalModel, TangentsAverageWhateverTheirSign) {
  Scan frame = seen_from({}, 0);
  LocalModel model = model_of(frame);
  for (std::size_t i = 0; i < frame.cloud.size(); ++i)
    if (frame.cloud.structures[i] == Structure::Edge) frame.cloud.directions[i] *= -1.0f;
  merge(model, frame, Rigid3{}, kMerge, 1);
  int num_edges = 0;
  for (std::size_t i = 0; i < frame.cloud.size(); ++i) {
    if (frame.cloud.structures[i] != Structure::Edge) continue;
    EXPECT_NEAR(std::abs(model.scan.cloud.directions[i].dot(frame.cloud.directions[i])), 1.0, 1e-5);
    ++num_edges;
  }
  EXPECT_GT(num_edges, 20);
}

TEST(LocalModel, NeverGrowsBeyondOnePointAPixelNorItsWeightBeyondTheLimit) {
  const Scan frame = seen_from({}, 1);
  LocalModel model = model_of(frame);
  for (int k = 0; k < 60; ++k) {
    const double shift = 0.02 * (k % 5);
    merge(model, frame, {Eigen::Quaterniond::Identity(), {shift, shift, 0.0}}, kMerge, 1);
  }
  const IndexImage& index = model.scan.view->index;
  EXPECT_LE(model.scan.cloud.size(), index.index.size());
  for (const float weight : model.weights) EXPECT_LE(weight, kMerge.max_weight);
}

TEST(LocalModel, IsCarriedOverToANewView) {
  const Rigid3 moved{rotation_exp({0.0, 0.1, 0.0}), {0.1, 0.0, 0.0}};
  LocalModel model = model_of(seen_from({}, 1));
  for (unsigned seed = 2; seed <= 12; ++seed) merge(model, seen_from({}, seed), Rigid3{}, kMerge, 1);
  const Scan keyframe = seen_from(moved, 20), exact = seen_from(moved, 0);
  const LocalModel carried = carried_over(model, keyframe, inverse(moved), kMerge, 1);
  EXPECT_LT(median_distance(carried.scan, exact), 0.8 * median_distance(keyframe, exact));
  EXPECT_GE(carried.scan.cloud.size(), keyframe.cloud.size() * 9 / 10) << "what only the keyframe sees is in it";
  for (std::size_t pixel = 0; pixel < carried.scan.view->index.index.size(); ++pixel)
    EXPECT_LT(carried.scan.view->index.index[pixel], static_cast<std::int32_t>(carried.scan.cloud.size()));
}

// The median distance of the Gaussians' means from the planes of their points, and the median cosine between these
// planes' normals and what the Gaussians hold.
struct GaussiansOff {
  double distance_m, cosine;
};
GaussiansOff gaussians_off(const Cloud& cloud) {
  std::vector<double> distances, cosines;
  for (std::size_t i = 0; i < cloud.gaussians.size(); ++i) {
    const PointGaussian& gaussian = cloud.gaussians[i];
    if (cloud.structures[i] != Structure::Planar || gaussian.information.isZero(0.0f)) continue;
    const Vec3f &normal = cloud.directions[i], held = gaussian.information * normal;
    distances.push_back(static_cast<double>(std::abs(normal.dot(gaussian.mean - cloud.points[i]))));
    cosines.push_back(static_cast<double>(normal.dot(held) / held.norm()));
  }
  const auto middle = [](std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values.at(values.size() / 2);
  };
  return {middle(distances), middle(cosines)};
}

// NDT's Gaussians move and average with their points: they are no farther from them than in one frame.
TEST(LocalModel, GaussiansStayWithTheirPoints) {
  RegistrationOptions ndt;
  ndt.method = Method::Ndt;
  const Rigid3 moved{rotation_exp({0.0, 0.1, 0.0}), {0.1, 0.0, 0.0}};
  const GaussiansOff of_frame = gaussians_off(seen_from({}, 1, ndt).cloud);
  LocalModel model = model_of(seen_from({}, 1, ndt));
  for (unsigned seed = 2; seed <= 4; ++seed) merge(model, seen_from({}, seed, ndt), Rigid3{}, kMerge, 1);
  const LocalModel carried = carried_over(model, seen_from(moved, 20, ndt), inverse(moved), kMerge, 1);
  for (const Cloud& cloud : {model.scan.cloud, carried.scan.cloud}) {
    ASSERT_TRUE(cloud.has_gaussians());
    EXPECT_LT(gaussians_off(cloud).distance_m, 1.1 * of_frame.distance_m);
    EXPECT_GT(gaussians_off(cloud).cosine, 0.99);
  }
}

TEST(LocalModel, WhatTheNewKeyframeSeesThroughIsDropped) {
  const Scan keyframe = seen_from({}, 0);
  LocalModel model = model_of(keyframe);
  for (Vec3f& point : model.scan.cloud.points) point *= 0.5f;  // half as near as the scene, on the same rays
  const LocalModel carried = carried_over(model, keyframe, Rigid3{}, kMerge, 1);
  EXPECT_EQ(carried.scan.cloud.points.size(), keyframe.cloud.points.size());
  EXPECT_LT(median_distance(carried.scan, keyframe), 1e-6);
}

}  // namespace
}  // namespace augicp
