// SPDX-License-Identifier: MIT
#include "augicp/testing/room_pair.h"

#include "augicp/testing/scenes.h"

namespace augicp::testing {

Scan noisy_view(const Scene& scene, const Rigid3& world_from_camera, unsigned seed, int width) {
  const Pinhole camera = kinect_like_camera(width);
  DepthImage image = render(scene, camera, camera.width, camera.height, world_from_camera).depth;
  add_depth_noise(image, kKinectSigmaAt1m, seed);
  return scan_of(image, camera);
}

ScanPair room_pair(const Rigid3& target_from_source) {
  const Scene scene = room();
  const Rigid3& place = scene.world_from_camera;
  return {noisy_view(scene, place * target_from_source, 1), noisy_view(scene, place, 2), target_from_source};
}

}  // namespace augicp::testing
