// SPDX-License-Identifier: MIT
// Writes generated rooms as folders that `augicp experiment verdict` reads: depth images with a Kinect's noise and
// steps, and their true trajectory. The camera walks in small steps and leaps to another place of the room every ten
// frames, so that frames one to nine apart overlap and frames farther apart may show nothing in common.
//
//   write_rooms FOLDER FIRST_SEED NUM_ROOMS NUM_FRAMES
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "augicp/io/depth_png.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

constexpr int kWidth = 160;
constexpr int kFramesPerPlace = 10;
constexpr double kDepthScale = 5000.0;

// Walls of their own: rooms of one size would have their corners in common.
Vec3d drawn_size(std::mt19937& generator) {
  return {testing::uniform(generator, 4.4, 7.0), testing::uniform(generator, 3.0, 5.5),
          testing::uniform(generator, 2.4, 3.2)};
}

Rigid3 drawn_place(const Vec3d& room_size, std::mt19937& generator) {
  const double x = 0.5 * room_size.x() - 0.3, y = 0.5 * room_size.y() - 0.3;
  const Vec3d eye(testing::uniform(generator, -x, x), testing::uniform(generator, -y, y),
                  testing::uniform(generator, 0.7, 2.2));
  const double yaw = testing::uniform(generator, 0.0, 2.0 * std::numbers::pi);
  const double pitch = testing::uniform(generator, -0.6, 0.2);
  return testing::look_at(
      eye, eye + Vec3d(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch)));
}

// Not inside furniture, and not with it before the lens.
bool sees_well(const DepthImage& image) {
  std::size_t num_seen = 0, num_near = 0;
  for (const float depth : image.depth) {
    num_seen += std::isfinite(depth);
    num_near += depth < 0.4f;
  }
  return num_seen > image.depth.size() / 20 && num_near < num_seen / 50;
}

void write_room(const std::filesystem::path& folder, unsigned seed, int num_frames) {
  std::filesystem::create_directories(folder / "depth");
  std::ofstream list(folder / "depth.txt"), truth(folder / "groundtruth.txt"), camera_file(folder / "camera.txt");
  truth.precision(12);
  const Pinhole camera = testing::kinect_like_camera(kWidth);
  camera_file.precision(12);
  camera_file << camera.fx << " " << camera.fy << " " << camera.cx << " " << camera.cy << "\n";
  std::mt19937 generator(seed);
  const Vec3d size = drawn_size(generator);
  const testing::Scene scene = testing::room(seed, size);
  Rigid3 place;
  for (int frame = 0; frame < num_frames; ++frame) {
    DepthImage image;
    for (int attempt = 0; attempt == 0 || !sees_well(image); ++attempt) {
      const bool leaps = frame % kFramesPerPlace == 0 || attempt > 20;
      const double angle = testing::uniform(generator, 0.0, 0.14), distance = testing::uniform(generator, 0.0, 0.12);
      const Rigid3 next =
          leaps ? drawn_place(size, generator) : place * testing::random_motion(generator, angle, distance);
      image = testing::render(scene, camera, camera.width, camera.height, next).depth;
      if (sees_well(image)) place = next;
    }
    testing::add_depth_noise(image, testing::kKinectSigmaAt1m, 1000 * seed + frame);
    testing::quantise_disparity(image);
    const std::string name = "depth/" + std::to_string(1000 + frame) + ".png";
    write_depth_png(folder / name, image, kDepthScale);
    const Vec3d& t = place.translation;
    const Eigen::Quaterniond& q = place.rotation;
    list << frame << ".0 " << name << "\n";
    // A pose just before and after: the truth is not asked between frames.
    for (const double moment : {frame - 0.01, frame + 0.01})
      truth << moment << " " << t.x() << " " << t.y() << " " << t.z() << " " << q.x() << " " << q.y() << " " << q.z()
            << " " << q.w() << "\n";
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::fprintf(stderr, "usage: write_rooms FOLDER FIRST_SEED NUM_ROOMS NUM_FRAMES\n");
    return 2;
  }
  const unsigned first = static_cast<unsigned>(std::atoi(arguments[2]));
  for (unsigned seed = first; seed < first + static_cast<unsigned>(std::atoi(arguments[3])); ++seed)
    write_room(std::filesystem::path(arguments[1]) / ("room_" + std::to_string(seed)), seed, std::atoi(arguments[4]));
  return 0;
}
