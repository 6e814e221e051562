// SPDX-License-Identifier: MIT
// Scenes whose shape leaves motions open, with a texture of growing contrast: how often the pose is held, with and
// without intensity, and how far it is from the truth. A Kinect's depth noise, brightness from 0 to 1 with a noise of
// 0.01, another exposure in the source, 3 cm and 1.7 degrees between the images.
//
//   textured_scenes [NUM_PAIRS]    prints the table of docs/lab/convergence.md
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

constexpr int kWidth = 320;
constexpr double kGreyNoise = 0.01, kExposureOffset = 0.1, kAngle = 0.03, kDistance = 0.03;
constexpr double kContrasts[] = {0.0, 0.02, 0.05, 0.2};

struct Place {
  const char* name;
  testing::Scene scene;
};

double texture(const Vec3d& p, double contrast) {
  return 0.5 + contrast * (std::sin(9.0 * p.x() + 2.0 * p.z()) + std::cos(11.0 * p.z() - 4.0 * p.y()));
}

Scan seen(const testing::Scene& scene, const Rigid3& world_from_camera, double contrast, double offset, unsigned seed) {
  const Pinhole camera = testing::kinect_like_camera(kWidth);
  const DepthImage exact = testing::render(scene, camera, camera.width, camera.height, world_from_camera).depth;
  DepthImage depth = exact;
  testing::add_depth_noise(depth, testing::kKinectSigmaAt1m, seed);
  GreyImage grey{depth.width, depth.height, {}};
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(offset, kGreyNoise);
  for (int v = 0; v < depth.height; ++v)
    for (int u = 0; u < depth.width; ++u) {
      const Vec3d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
      const Vec3d point = world_from_camera * Vec3d(static_cast<double>(exact.at(u, v)) * ray);
      grey.value.push_back(static_cast<float>(texture(point, contrast) + noise(generator)));
    }
  return scan_of(depth, grey, DepthCamera{camera, {}, 0.0});
}

void print_row(const Place& place, double contrast, bool intensity, unsigned num_pairs) {
  unsigned num_converged = 0, num_degenerate = 0;
  std::vector<double> errors;
  const Rigid3& target_place = place.scene.world_from_camera;
  RegistrationOptions options;
  options.intensity = intensity;
  for (unsigned seed = 1; seed <= num_pairs; ++seed) {
    std::mt19937 generator(seed);
    const Rigid3 motion = testing::random_motion(generator, kAngle, kDistance);
    const AlignResult result =
        register_scans(seen(place.scene, target_place * motion, contrast, kExposureOffset, seed + num_pairs),
                       seen(place.scene, target_place, contrast, 0.0, seed), {}, options)
            .result;
    num_converged += result.status == AlignStatus::Converged;
    num_degenerate += result.status == AlignStatus::Degenerate;
    errors.push_back((result.target_from_source.translation - motion.translation).norm());
  }
  std::sort(errors.begin(), errors.end());
  std::printf("| %s | %.2f | %s | %u | %u | %.1f | %.1f |\n", place.name, contrast, intensity ? "with" : "without",
              num_converged, num_degenerate, 1000.0 * errors[errors.size() / 2], 1000.0 * errors.back());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned num_pairs = argc > 1 ? static_cast<unsigned>(std::max(1, std::atoi(argv[1]))) : 8u;
  const std::vector<Place> places{{"wall", testing::single_plane()},
                                  {"corridor", testing::corridor()},
                                  {"cylinder", testing::cylinder_scene()},
                                  {"sphere", testing::sphere_scene()}};
  std::printf("| scene | contrast | intensity | converged | degenerate | median, mm | largest, mm |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Place& place : places)
    for (const double contrast : kContrasts)
      for (const bool intensity : {false, true})
        if (intensity || contrast == 0.0)
          print_row(place, contrast, intensity, num_pairs);  // without, texture is not seen
}
