// SPDX-License-Identifier: MIT
#include "augicp/align/align.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>

#include "augicp/core/error.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_neighbourhood.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/random_clouds.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::NearPose;
using testing::NearVector;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kRadius = 0.08;  // of the ball that surfaces are estimated in, metres

// What the camera sees from its place in a generated scene, moved by a motion in its own frame.
struct View {
  OrganizedCloud organized;
  Pinhole camera;
  const Cloud& cloud() const { return organized.cloud; }
};

View view_of(const testing::Scene& scene, const Rigid3& motion = {}, int width = 120) {
  const Pinhole camera = testing::kinect_like_camera(width);
  const Rigid3 world_from_camera = scene.world_from_camera * motion;
  View view{unproject(testing::render(scene, camera, camera.width, camera.height, world_from_camera).depth, camera),
            camera};
  const WindowNeighbourhood window(view.organized.cloud, view.organized.index, {.radius = kRadius}, 2);
  estimate_surface(view.organized.cloud, window, {}, 2);
  return view;
}

AlignOptions near_options() {
  AlignOptions options;
  options.gates = {.max_distance = 0.2, .max_angle = 0.7};
  // Without a limit, exact normals outweigh everything: no translation would count beside the turn.
  options.max_lever = 2.0 * kRadius;
  options.num_threads = 2;
  return options;
}

bool reached(const AlignResult& result) {
  return result.status == AlignStatus::Converged || result.status == AlignStatus::IterationLimit;
}

const Rigid3 kSmallMotion = [] {
  std::mt19937 generator(31);
  return testing::random_motion(generator, 0.04, 0.03);
}();

// Not the identity, so that a pose replaced by it would show.
const Rigid3 kGuess = [] {
  std::mt19937 generator(32);
  return testing::random_motion(generator, 0.3, 0.5);
}();

TEST(Align, FindsASmallMotionFromDepthImages) {
  const testing::Scene scene = testing::room();
  const View target = view_of(scene), source = view_of(scene, kSmallMotion);
  const NearestMatcher nearest(target.cloud());
  const ProjectiveMatcher projective(target.cloud(), target.organized.index, target.camera);
  for (const Matcher* matcher : {static_cast<const Matcher*>(&nearest), static_cast<const Matcher*>(&projective)}) {
    AlignOptions options = near_options();
    // Exact depth fits most planes perfectly, and a kernel at their median would silence all the others.
    options.min_kernel_chi2 = options.information.planar.position.along * 1e-4 * kRadius * kRadius;
    const AlignResult result = align(source.cloud(), *matcher, Rigid3{}, options);
    EXPECT_TRUE(reached(result)) << name_of(result.status);
    EXPECT_THAT(result.target_from_source, NearPose(kSmallMotion, 2e-3, 3e-3));
  }
}

// The same points moved: nothing is left of the error once the pairs are right.
// From the identity between the clouds' frames to the pose between them: transform() moves origins too.
Rigid3 aligned_frames(const Cloud& source, const Cloud& target, const AlignOptions& options) {
  const AlignResult result = align(source, NearestMatcher(target), without_origins(Rigid3{}, source, target), options);
  EXPECT_EQ(result.status, AlignStatus::Converged);
  return with_origins(result.target_from_source, source, target);
}

TEST(Align, IsExactWhereAnExactAnswerExists) {
  const View target = view_of(testing::room());
  const Cloud source = transform(target.cloud(), inverse(kSmallMotion));
  const std::pair<std::string, InformationModel> models[]{{"point", point_information()},
                                                          {"plane", plane_information()},
                                                          {"gicp", gicp_information()},
                                                          {"augmented", augmented_information()},
                                                          {"default", default_information()}};
  for (const auto& [name, model] : models) {
    AlignOptions options = near_options();
    options.information = model;
    options.max_iterations = 100;
    // Without noise the median of the distances to planes falls to nothing as soon as most planes fit, and K with it;
    // what the rest of the planes say is then lost beside the damping.
    if (name == "plane") options.kernel_chi2 = 1e-3;
    EXPECT_THAT(aligned_frames(source, target.cloud(), options), NearPose(kSmallMotion, 1e-4, 2e-4)) << name;
  }
}

// robustness 10: a cloud against itself.
TEST(Align, ACloudMeetsItselfAtTheIdentity) {
  const View view = view_of(testing::room());
  const AlignResult result = align(view.cloud(), NearestMatcher(view.cloud()), Rigid3{}, near_options());
  EXPECT_EQ(result.status, AlignStatus::Converged);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_THAT(result.target_from_source, NearPose(Rigid3{}, 1e-9, 1e-9));
  EXPECT_EQ(result.overlap, 1.0);
  EXPECT_EQ(result.rmse, 0.0);
}

TEST(Align, HistoryHasOneEntryForEachIteration) {
  const View target = view_of(testing::room()), source = view_of(testing::room(), kSmallMotion);
  AlignOptions options = near_options();
  options.max_iterations = 3;
  options.min_observability = 0.0;
  options.min_translation_step = options.min_rotation_step = 0.0;
  const AlignResult result = align(
      source.cloud(), ProjectiveMatcher(target.cloud(), target.organized.index, target.camera), Rigid3{}, options);
  EXPECT_EQ(result.status, AlignStatus::IterationLimit);
  EXPECT_EQ(result.iterations, 3);
  ASSERT_EQ(result.history.size(), 3u);
  EXPECT_THAT(result.history.back().target_from_source, NearPose(result.target_from_source, 0.0, 0.0));
  EXPECT_LT(result.history[2].cost / static_cast<double>(result.history[2].num_pairs),
            result.history[0].cost / static_cast<double>(result.history[0].num_pairs));
  for (const AlignIteration& iteration : result.history) {
    EXPECT_GT(iteration.num_pairs, 0);
    EXPECT_GT(iteration.kernel_chi2, 0.0);
    EXPECT_GT(iteration.lever, 0.0);
  }
}

struct Failure {
  std::string name;
  Cloud source;
  Cloud target;
  AlignStatus status;
};

Cloud shifted(Cloud cloud, const Vec3f& shift) {
  for (Vec3f& point : cloud.points) point += shift;
  return cloud;
}

std::vector<Failure> failures() {
  const Cloud cloud = testing::random_extended_points(3000, 1.0, 33);
  Cloud all_equal;
  all_equal.points.assign(5000, Vec3f(0.1f, 0.2f, 0.3f));
  std::vector<Failure> failures{
      {"empty source", {}, cloud, AlignStatus::TooFewPairs},
      {"empty target", cloud, {}, AlignStatus::TooFewPairs},
      {"both empty", {}, {}, AlignStatus::TooFewPairs},
      {"100 m apart", cloud, shifted(cloud, {100.0f, 0.0f, 0.0f}), AlignStatus::NoOverlap},
      {"equal points apart", all_equal, shifted(all_equal, {5.0f, 0.0f, 0.0f}), AlignStatus::NoOverlap}};
  for (std::size_t count = 1; count <= 5; ++count) {
    const Cloud few = testing::random_extended_points(count, 1.0, 34);
    failures.push_back({std::to_string(count) + " source points", few, cloud, AlignStatus::TooFewPairs});
    failures.push_back({std::to_string(count) + " target points", cloud, few, AlignStatus::TooFewPairs});
    failures.push_back({std::to_string(count) + " points", few, few, AlignStatus::TooFewPairs});
  }
  return failures;
}

// robustness 10: a failure says so, and keeps the pose it had.
TEST(Align, FailureKeepsTheGuess) {
  AlignOptions options = near_options();
  options.gates = {.max_distance = 2.0};
  for (const auto& [name, source, target, status] : failures()) {
    const AlignResult result = align(source, NearestMatcher(target), kGuess, options);
    EXPECT_EQ(name_of(result.status), name_of(status)) << name;
    EXPECT_THAT(result.target_from_source, NearPose(kGuess, 1e-12, 1e-12)) << name;
    EXPECT_EQ(result.iterations, 0) << name;
    EXPECT_TRUE(result.history.empty()) << name;
    EXPECT_TRUE(std::isfinite(result.rmse)) << name;
  }
}

TEST(Align, FewPairsAmongManyPointsAreNoOverlap) {
  const Cloud cloud = testing::random_points(1000, 1.0, 35);
  AlignOptions options = near_options();
  options.gates = {.max_distance = 0.01};
  Cloud source = shifted(cloud, {50.0f, 0.0f, 0.0f});
  for (std::size_t i = 0; i < 19; ++i) source.points[i] = cloud.points[i];
  EXPECT_EQ(align(source, NearestMatcher(cloud), Rigid3{}, options).status, AlignStatus::NoOverlap);
  source.points.resize(40);
  EXPECT_NE(align(source, NearestMatcher(cloud), Rigid3{}, options).status, AlignStatus::NoOverlap);
}

// They fix no turn: the status says so, and no number ceases to be one.
TEST(Align, EqualPointsAreDegenerate) {
  Cloud all_equal;
  all_equal.points.assign(5000, Vec3f(0.1f, 0.2f, 0.3f));
  AlignOptions options = near_options();
  options.gates = {};
  const AlignResult result = align(all_equal, NearestMatcher(all_equal), kGuess, options);
  EXPECT_EQ(result.status, AlignStatus::Degenerate);
  EXPECT_TRUE(result.target_from_source.translation.allFinite());
  EXPECT_LE(result.target_from_source.rotation.coeffs().norm(), 1.0 + 1e-12);
}

TEST(Align, AGuessThatIsNotANumberFails) {
  const Cloud cloud = testing::random_extended_points(3000, 1.0, 36);
  Rigid3 guess;
  guess.translation.x() = std::nan("");
  EXPECT_FALSE(reached(align(cloud, NearestMatcher(cloud), guess, near_options())));
}

struct BadOption {
  std::string name;
  std::function<void(AlignOptions&, double)> set;
  std::vector<double> bad;
};

TEST(Align, OptionsOutOfRangeAreRefusedByName) {
  const double nan = std::nan("");
  const std::vector<BadOption> options{
      {"information",
       [](AlignOptions& o, double x) { o.information.planar.position.along = x; },
       {-1.0, nan, kInfinity}},
      {"max_distance", [](AlignOptions& o, double x) { o.gates.max_distance = x; }, {0.0, -1.0, nan}},
      {"max_angle", [](AlignOptions& o, double x) { o.gates.max_angle = x; }, {0.0, -1.0, nan}},
      {"lever", [](AlignOptions& o, double x) { o.lever = x; }, {-1.0, nan, kInfinity}},
      {"max_lever", [](AlignOptions& o, double x) { o.max_lever = x; }, {-1.0, nan}},
      {"kernel_chi2", [](AlignOptions& o, double x) { o.kernel_chi2 = x; }, {0.0, -1.0, nan}},
      {"kernel_quantile", [](AlignOptions& o, double x) { o.kernel_quantile = x; }, {0.0, -0.1, 0.6, nan}},
      {"kernel_per_median", [](AlignOptions& o, double x) { o.kernel_per_median = x; }, {0.0, -1.0, nan, kInfinity}},
      {"damping", [](AlignOptions& o, double x) { o.damping = x; }, {-1.0, nan, kInfinity}},
      {"max_iterations", [](AlignOptions& o, double x) { o.max_iterations = static_cast<int>(x); }, {0.0, -1.0}},
      {"min_translation_step", [](AlignOptions& o, double x) { o.min_translation_step = x; }, {-1.0, nan, kInfinity}},
      {"min_rotation_step", [](AlignOptions& o, double x) { o.min_rotation_step = x; }, {-1.0, nan, kInfinity}},
      {"min_observability", [](AlignOptions& o, double x) { o.min_observability = x; }, {-1.0, nan, kInfinity}},
      {"num_threads", [](AlignOptions& o, double x) { o.num_threads = static_cast<int>(x); }, {-1.0}}};
  const Cloud cloud = testing::random_points(10, 1.0, 37);
  const NearestMatcher matcher(cloud);
  for (const auto& [name, set, bad] : options) {
    for (double value : bad) {
      AlignOptions changed;
      set(changed, value);
      try {
        align(cloud, matcher, Rigid3{}, changed);
        ADD_FAILURE() << name << " = " << value << " was taken";
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0u) << error.what();
      }
    }
  }
  EXPECT_NO_THROW(AlignOptions{}.check());
}

// Origins are the caller's matter: align() sees the points alone.
TEST(Align, OriginsChangeNothing) {
  const View target_view = view_of(testing::room()), source_view = view_of(testing::room(), kSmallMotion);
  const NearestMatcher near_matcher(target_view.cloud());
  const Rigid3 expected = align(source_view.cloud(), near_matcher, Rigid3{}, near_options()).target_from_source;
  Cloud source = source_view.cloud(), target = target_view.cloud();
  source.origin += Vec3d(1e7, -5e6, 1e6);
  target.origin -= Vec3d(3.0, 2.0, 1.0);
  const AlignResult result = align(source, NearestMatcher(target), Rigid3{}, near_options());
  EXPECT_EQ(result.target_from_source.matrix(), expected.matrix());
}

// robustness 16: after its steps the result is a rotation still.
TEST(Align, ResultIsARigidMotion) {
  const View target = view_of(testing::room()), source = view_of(testing::room(), kSmallMotion);
  AlignOptions options = near_options();
  options.max_iterations = 30;
  options.min_translation_step = options.min_rotation_step = 0.0;
  const AlignResult result = align(source.cloud(), NearestMatcher(target.cloud()), Rigid3{}, options);
  ASSERT_EQ(result.iterations, 30);
  const Mat3d rotation = result.target_from_source.rotation.toRotationMatrix();
  EXPECT_LT((rotation * rotation.transpose() - Mat3d::Identity()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
}

// robustness 16: moving both clouds moves the result with them.
TEST(Align, ResultMovesWithBothClouds) {
  const View target = view_of(testing::room()), source = view_of(testing::room(), kSmallMotion);
  const Rigid3 expected =
      align(source.cloud(), NearestMatcher(target.cloud()), Rigid3{}, near_options()).target_from_source;
  std::mt19937 generator(38);
  for (int i = 0; i < 3; ++i) {
    const Rigid3 motion = testing::random_motion(generator, 2.0, 10.0);
    const Cloud moved_source = transform(source.cloud(), motion), moved_target = transform(target.cloud(), motion);
    const Rigid3 moved = aligned_frames(moved_source, moved_target, near_options());
    EXPECT_THAT(inverse(motion) * moved * motion, NearPose(expected, 5e-5, 1e-4));
  }
}

TEST(Align, SameBitsForAnyNumberOfThreads) {
  const View target = view_of(testing::room(), {}, 240), source = view_of(testing::room(), kSmallMotion, 240);
  ASSERT_GT(source.cloud().size(), 2 * kLightBlockSize);
  const NearestMatcher nearest(target.cloud());
  const ProjectiveMatcher projective(target.cloud(), target.organized.index, target.camera);
  for (const Matcher* matcher : {static_cast<const Matcher*>(&nearest), static_cast<const Matcher*>(&projective)}) {
    AlignOptions options = near_options();
    options.max_iterations = 3;
    options.num_threads = 1;
    const AlignResult expected = align(source.cloud(), *matcher, Rigid3{}, options);
    for (int num_threads : {2, 3, 8}) {
      options.num_threads = num_threads;
      const AlignResult result = align(source.cloud(), *matcher, Rigid3{}, options);
      EXPECT_EQ(result.target_from_source.matrix(), expected.target_from_source.matrix());
      EXPECT_EQ(result.information, expected.information);
      EXPECT_EQ(result.rmse, expected.rmse);
      EXPECT_EQ(result.num_pairs, expected.num_pairs);
    }
  }
}

TEST(Align, EveryStatusHasItsName) {
  EXPECT_EQ(name_of(AlignStatus::Converged), "converged");
  EXPECT_EQ(name_of(AlignStatus::NoOverlap), "no_overlap");
  EXPECT_EQ(name_of(AlignStatus::Diverged), "diverged");
}

// No step comes of sums that overflow: the pose stays what it was.
TEST(Align, WhatOverflowsDiverges) {
  const View view = view_of(testing::room());
  AlignOptions options = near_options();
  options.kernel_chi2 = kInfinity;
  options.information = point_information();
  for (StructureInformation* row : {&options.information.none, &options.information.planar, &options.information.edge})
    row->position = {1e308, 1e308};
  const AlignResult result = align(view.cloud(), NearestMatcher(view.cloud()), kSmallMotion, options);
  EXPECT_EQ(result.status, AlignStatus::Diverged);
  EXPECT_THAT(result.target_from_source, NearPose(kSmallMotion, 0.0, 0.0));
}

// Asks for an end from another thread, while it looks for the pairs of its third iteration.
class StoppingMatcher final : public Matcher {
 public:
  explicit StoppingMatcher(const Cloud& target) : nearest(target) {}
  const Cloud& target() const override { return nearest.target(); }
  std::vector<Correspondence> match(const Cloud& source, const Rigid3& pose, const Gates& gates,
                                    int num_threads) const override {
    if (++*num_calls == 3) std::thread([this] { stop->request_stop(); }).join();
    return nearest.match(source, pose, gates, num_threads);
  }

  NearestMatcher nearest;
  std::shared_ptr<int> num_calls = std::make_shared<int>(0);
  std::shared_ptr<std::stop_source> stop = std::make_shared<std::stop_source>();
};

TEST(AlignInterrupted, EndsBeforeTheNextIteration) {
  const View target = view_of(testing::room()), source = view_of(testing::room(), kSmallMotion);
  const StoppingMatcher matcher(target.cloud());
  AlignOptions options = near_options();
  options.min_translation_step = options.min_rotation_step = 0.0;  // it would go on
  options.stop = matcher.stop->get_token();
  EXPECT_THROW(align(source.cloud(), matcher, Rigid3{}, options), Interrupted);
  EXPECT_EQ(*matcher.num_calls, 3);
}

TEST(AlignInterrupted, DoesNothingWhereAnEndWasAskedForBefore) {
  const View view = view_of(testing::room());
  std::stop_source stop;
  AlignOptions options = near_options();
  options.stop = stop.get_token();
  EXPECT_EQ(align(view.cloud(), NearestMatcher(view.cloud()), Rigid3{}, options).status, AlignStatus::Converged);
  stop.request_stop();
  EXPECT_THROW(align(view.cloud(), NearestMatcher(view.cloud()), Rigid3{}, options), Interrupted);
}

}  // namespace
}  // namespace augicp
