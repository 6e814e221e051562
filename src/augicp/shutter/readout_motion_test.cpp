// SPDX-License-Identifier: MIT
#include "augicp/shutter/readout_motion.h"

#include <gmock/gmock.h>

#include "augicp/geometry/rotation.h"
#include "augicp/registration/registration.h"
#include "augicp/shutter/rolling_shutter.h"
#include "augicp/testing/matchers.h"
#include "augicp/testing/rolling_camera.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

using testing::NearPose;

// A camera that rotates to and fro: one way during the readout of the source, the other way during that of the target.
struct Swing {
  Scan source, target;
  Rigid3 target_from_source{rotation_exp({0.02, -0.03, 0.01}), {0.03, 0.0, -0.02}};
  Rigid3 turn{rotation_exp({0.02, 0.03, -0.01}), Vec3d::Zero()};
};

Swing swing() {
  Swing swing;
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(160);
  const auto seen = [&](const Rigid3& world_from_camera, const Rigid3& first_from_last, unsigned seed) {
    DepthImage image = testing::render_rolling(room, camera, world_from_camera, first_from_last);
    testing::add_depth_noise(image, testing::kKinectSigmaAt1m, seed);
    return scan_of(image, DepthCamera{camera, {}, 1.0 / 30.0});
  };
  swing.source = seen(room.world_from_camera * swing.target_from_source, swing.turn, 1);
  swing.target = seen(room.world_from_camera, inverse(swing.turn), 2);
  return swing;
}

TEST(ReadoutMotion, ASwingIsFoundAndItsPoseStraightened) {
  const Swing pair = swing();
  RegistrationOptions bent;
  bent.rolling_shutter = false;
  const Rigid3 without = register_scans(pair.source, pair.target, {}, bent).result.target_from_source,
               with = register_scans(pair.source, pair.target).result.target_from_source;
  EXPECT_LT(angle_between(with, pair.target_from_source), 0.5 * angle_between(without, pair.target_from_source));
  EXPECT_THAT(with, NearPose(pair.target_from_source, 0.01, 0.01));
}

TEST(ReadoutMotion, AStillCameraIsLeftAsItIs) {
  const testing::Scene room = testing::room();
  const Pinhole camera = testing::kinect_like_camera(160);
  const Scan raw = scan_of(testing::render(room, camera).depth, camera);
  const Scan scan = prepare(raw, lengths_for(raw, raw, {}), {});
  std::vector<Correspondence> same;
  for (std::uint32_t i = 0; i < scan.cloud.size(); ++i) same.push_back({i, i});
  // Exact pairs leave no error, and without errors the motion stays unchanged.
  const ReadoutMotion motion = improved({}, {scan, scan, scan, scan}, same, {});
  EXPECT_THAT(motion.source, NearPose(Rigid3{}, 1e-6, 1e-6));
  EXPECT_THAT(motion.target, NearPose(Rigid3{}, 1e-6, 1e-6));
}

TEST(ReadoutMotion, TooFewPairsChangeNothing) {
  const Swing pair = swing();
  const ReadoutMotion so_far{pair.turn, inverse(pair.turn)};
  const Scan source = prepare(pair.source, lengths_for(pair.source, pair.target, {}), {});
  const ReadoutMotion motion = improved(so_far, {source, source, source, source}, {}, {});
  EXPECT_THAT(motion.source, NearPose(so_far.source, 0.0, 0.0));
}

}  // namespace
}  // namespace augicp
