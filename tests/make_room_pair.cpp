// SPDX-License-Identifier: MIT
// Makes data/room_pair: two noisy scans of a generated room from two places, each in its own camera's frame, and the
// motion between them.   make_room_pair FOLDER
#include <bit>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

#include "augicp/geometry/rotation.h"
#include "augicp/sensor/depth_image.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

Cloud scan(const testing::Scene& scene, const Rigid3& world_from_camera, unsigned noise_seed) {
  const Pinhole camera = testing::kinect_like_camera(184);  // 25 392 pixels
  DepthImage depth = testing::render(scene, camera, camera.width, camera.height, world_from_camera).depth;
  testing::add_depth_noise(depth, testing::kKinectSigmaAt1m, noise_seed);
  return unproject(depth, camera).cloud;
}

std::ofstream open(const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be written");
  return file;
}

void write_ply(const std::string& path, const Cloud& cloud) {
  static_assert(std::endian::native == std::endian::little && sizeof(Vec3f) == 12);
  std::ofstream file = open(path);
  file << "ply\nformat binary_little_endian 1.0\ncomment generated, metres, camera at the origin\nelement vertex "
       << cloud.size() << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  file.write(reinterpret_cast<const char*>(cloud.points.data()), static_cast<std::streamsize>(12 * cloud.size()));
}

void write_transform(const std::string& path, const Rigid3& b_from_a) {
  std::ofstream file = open(path);
  file.precision(17);
  const Mat4d matrix = b_from_a.matrix();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) file << matrix(row, column) << (column == 3 ? '\n' : ' ');
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: make_room_pair FOLDER");
  const std::string folder = argv[1];
  const testing::Scene scene = testing::room(1);
  const Rigid3& world_from_source = scene.world_from_camera;
  // In the camera's frame: 25 cm to the right, 10 cm down, 20 cm ahead, and a turn by 15 degrees, mostly about the
  // vertical.
  const Rigid3 source_from_target{rotation_exp(Vec3d(0.05, 0.255, 0.03)), Vec3d(0.25, 0.1, 0.2)};
  write_ply(folder + "/source.ply", scan(scene, world_from_source, 1));
  write_ply(folder + "/target.ply", scan(scene, world_from_source * source_from_target, 2));
  write_transform(folder + "/T_target_source.txt", inverse(source_from_target));
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_room_pair: %s\n", error.what());
  return 1;
}
