// SPDX-License-Identifier: MIT
// The experiments on sequences, on small ones rendered of a room whose truth is known.
#include <gtest/gtest.h>

#include "augicp/core/error.h"
#include "augicp/experiment/sequence.h"
#include "augicp/experiment/verdict.h"
#include "augicp/geometry/rotation.h"
#include "augicp/io/depth_png.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using testing::NearPose;

constexpr std::size_t kFrames = 4;
constexpr double kFramePeriod_s = 1.0 / 30.0, kDepthScale = 5000.0;
const Pinhole kCamera = testing::kinect_like_camera(80);

Rigid3 first_from_camera(std::size_t k) {
  const auto n = static_cast<double>(k);
  return {rotation_exp({0.004 * n, 0.01 * n, 0.0}), {0.01 * n, 0.002 * n, 0.005 * n}};
}

Rigid3 true_motion(std::size_t target, std::size_t source) {
  return inverse(first_from_camera(target)) * first_from_camera(source);
}

// Images of a generated room with a Kinect's noise, in a folder that goes with this.
class RoomSequence {
 public:
  explicit RoomSequence(const testing::Scene& room = testing::room()) {
    sequence.depth_scale = kDepthScale;
    sequence.truth.emplace();
    for (std::size_t k = 0; k < kFrames; ++k) {
      DepthImage image =
          testing::render(room, kCamera, kCamera.width, kCamera.height, room.world_from_camera * first_from_camera(k))
              .depth;
      testing::add_depth_noise(image, testing::kKinectSigmaAt1m, static_cast<unsigned>(k) + 1);
      const auto path = folder_ / (std::to_string(k) + ".png");
      write_depth_png(path, image, kDepthScale);
      const double stamp_s = static_cast<double>(k) * kFramePeriod_s;
      sequence.frames.push_back({stamp_s, path});
      sequence.truth->push_back({stamp_s, first_from_camera(k)});
    }
  }

  DepthSequence sequence;

 private:
  testing::TemporaryFolder folder_;
};

SequenceOptions default_only() {
  SequenceOptions options;
  options.gaps = {1, 2};
  options.presets = {Preset::Default};
  options.methods = {Method::Plane, Method::Augmented};
  options.iterations = 6;
  return options;
}

VerdictOptions verdict_options(const std::vector<std::size_t>& gaps, std::size_t num_across) {
  VerdictOptions options;
  options.gaps = gaps;
  options.num_across = num_across;
  options.pixel_step = 1;
  return options;
}

std::vector<SequenceCurve> run(const DepthSequence& sequence, const SequenceOptions& options) {
  return run_sequence(sequence, {kCamera, {}}, options, [] {});
}

TEST(RunSequence, EveryPairIsRunByEveryMethodAndComesNearTheTruth) {
  const RoomSequence room;
  int num_targets = 0;
  const auto curves = run_sequence(room.sequence, {kCamera, {}}, default_only(), [&] { ++num_targets; });
  EXPECT_EQ(num_targets, 2);
  ASSERT_EQ(curves.size(), 8u);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const SequenceCurve& curve = curves[k];
    EXPECT_EQ(curve.target, k / 4);
    EXPECT_EQ(curve.gap(), k / 2 % 2 + 1);
    EXPECT_EQ(curve.method, k % 2 == 0 ? Method::Plane : Method::Augmented);
    EXPECT_EQ(curve.source_stamp_s, static_cast<double>(curve.source) * kFramePeriod_s);
    ASSERT_EQ(curve.path.size(), 7u);
    EXPECT_THAT(curve.path.front(), NearPose(Rigid3{}, 0.0, 0.0));
    EXPECT_THAT(curve.path.back(), NearPose(true_motion(curve.target, curve.source), 0.006, 0.015)) << k;
  }
}

TEST(RunSequence, SurfacesOfAnySurroundingsLeadThere) {
  const RoomSequence room;
  SequenceOptions options = default_only();
  options.max_targets = 1;
  std::vector<Mat4d> ends;
  for (const Surroundings surroundings : {Surroundings::Window, Surroundings::Square, Surroundings::Ball}) {
    options.surroundings = surroundings;
    const SequenceCurve curve = run(room.sequence, options).back();
    EXPECT_THAT(curve.path.back(), NearPose(true_motion(0, 2), 0.006, 0.015));
    for (const Mat4d& other : ends) EXPECT_NE(curve.path.back().matrix(), other) << "other points give other surfaces";
    ends.push_back(curve.path.back().matrix());
  }
}

TEST(RunSequence, StartsAtTheGuessWhereThereIsOne) {
  const RoomSequence room;
  SequenceOptions options = default_only();
  options.guess = {*room.sequence.truth, 0.0};
  options.guess->trajectory.pop_back();
  for (const SequenceCurve& curve : run(room.sequence, options)) {
    const bool is_known = curve.source + 1 < kFrames;
    EXPECT_THAT(curve.path.front(),
                NearPose(is_known ? true_motion(curve.target, curve.source) : Rigid3{}, 1e-12, 1e-12));
  }
}

TEST(RunSequence, AnImageThatCannotBeReadIsAnError) {
  RoomSequence room;
  room.sequence.frames[2].path += ".gone";
  EXPECT_THROW(run(room.sequence, default_only()), IoError);
  const VerdictSequence in{"room", room.sequence, {kCamera, {}}};
  EXPECT_THROW(run_verdict({&in, 1}, verdict_options({1}, 0), [] {}), IoError);
}

class RunVerdict : public ::testing::Test {
 protected:
  const RoomSequence first_, second_{testing::box_on_table()};
  std::vector<VerdictSequence> rooms_{{"room", first_.sequence, {kCamera, {}}},
                                      {"table", second_.sequence, {kCamera, {}}}};
};

TEST_F(RunVerdict, KnowsTheTruthOfEveryPairAndTrustsNoneApart) {
  for (const bool as_clouds : {false, true}) {
    VerdictOptions options = verdict_options({1}, 2);
    options.as_clouds = as_clouds;
    std::size_t num_told = 0;
    const auto pairs = run_verdict(rooms_, options, [&] { ++num_told; });
    EXPECT_EQ(pairs.size(), num_pairs(rooms_, options));
    EXPECT_EQ(pairs.size(), num_told);
    ASSERT_EQ(pairs.size(), 2u * 3u + 2u);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const VerdictPair& pair = pairs[k];
      const bool is_across = k >= 6;
      EXPECT_EQ(pair.target_sequence != pair.source_sequence, is_across);
      EXPECT_EQ(pair.error.has_value(), !is_across);
      EXPECT_EQ(pair.truth, is_across ? PairTruth::Apart : PairTruth::Right) << k;
      if (is_across) {
        EXPECT_NE(pair.status, AlignStatus::Converged) << k;
      } else {
        EXPECT_GT(pair.true_overlap, 0.8) << k;
      }
    }
  }
}

TEST_F(RunVerdict, WithoutTruthThereAreNoPairsWithin) {
  for (VerdictSequence& room : rooms_) room.sequence.truth.reset();
  EXPECT_EQ(num_pairs(rooms_, verdict_options({1}, 2)), 2u);
  EXPECT_EQ(num_pairs(std::span(rooms_).first(1), verdict_options({1}, 2)), 0u) << "across takes two";
  rooms_[0].sequence.truth = Trajectory{{100.0, {}}, {101.0, {}}};
  EXPECT_EQ(num_pairs(rooms_, verdict_options({1}, 0)), 0u) << "truth of another time";
}

}  // namespace
}  // namespace augicp
