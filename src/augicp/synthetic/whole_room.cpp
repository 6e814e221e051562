// SPDX-License-Identifier: MIT
#include "augicp/synthetic/whole_room.h"

#include "augicp/cloud/voxel_grid.h"
#include "augicp/experiment/random.h"
#include "augicp/sensor/depth_image.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp::synthetic {
namespace {

constexpr int kColumns = 160;
constexpr std::size_t kPoints = 20000;

// Metres: of a room of this size, from near its upper corners to the middle of the other side.
const Vec3d kSize{5.0, 4.0, 2.6};
const Vec3d kCorner{2.3, 1.8, 2.4}, kLookedAt{-0.8, -0.6, 0.6};

}  // namespace

Cloud whole_room(unsigned seed, std::mt19937& generator) {
  const testing::Scene scene = testing::room(seed, kSize);
  const Pinhole camera = testing::kinect_like_camera(kColumns);
  Cloud room;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) {
      const Vec3d side(x, y, 1.0);
      const Vec3d beside = 0.1 * random_direction(generator);
      const Rigid3 place = testing::look_at(side.cwiseProduct(kCorner) - beside, side.cwiseProduct(kLookedAt));
      DepthImage image = testing::render(scene, camera, camera.width, camera.height, place).depth;
      testing::add_depth_noise(image, testing::kKinectSigmaAt1m, static_cast<unsigned>(generator()));
      for (const Vec3f& in_camera : unproject(image, camera).cloud.points)
        room.points.push_back((place * in_camera.cast<double>()).cast<float>());
    }
  return evenly_chosen(room, kPoints);
}

}  // namespace augicp::synthetic
