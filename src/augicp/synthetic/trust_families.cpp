// SPDX-License-Identifier: MIT
#include <numbers>
#include <utility>

#include "augicp/core/angles.h"
#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/objects.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/synthetic/trust_benchmark.h"
#include "augicp/synthetic/whole_room.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp::synthetic {
namespace {

using testing::Scene;

template <typename T, std::size_t kCount>
T drawn_from(const T (&choices)[kCount], std::mt19937& generator) {
  return choices[generator() % kCount];
}

// Not by the seed's remainder: then odd and even seeds would draw different ones.
Object one_of(const std::vector<Object>& objects, std::mt19937& generator) {
  return objects[generator() % objects.size()];
}

Vec6d along(const Vec3d& axis) { return (Vec6d() << axis, Vec3d::Zero()).finished(); }
// Through the frame's zero.
Vec6d about(const Vec3d& axis) { return (Vec6d() << Vec3d::Zero(), axis).finished(); }

// Of 16 to 128 rings, with noise of 0 to 3 cm and a range of 20 to 60 m.
Lidar some_lidar(std::mt19937& generator) {
  Lidar lidar;
  lidar.num_rings = drawn_from({16, 32, 64, 128}, generator);
  lidar.num_azimuths = 900;
  lidar.min_elevation_deg = lidar.num_rings == 16 ? -15.0 : -25.0;
  lidar.max_elevation_deg = 15.0;
  lidar.max_range = drawn_from({20.0, 40.0, 60.0}, generator);
  lidar.range_sigma = drawn_from({0.0, 0.01, 0.03}, generator);
  return lidar;
}

// Motions about the world's zero that leave the scene as it is, as increments about the target's.
std::vector<Vec6d> in_target(const std::vector<Vec6d>& free_in_world, const Rigid3& world_from_target) {
  const Rigid3 target_from_world = inverse(world_from_target);
  std::vector<Vec6d> free;
  for (const Vec6d& of_world : free_in_world) {
    const Vec3d turn = target_from_world.rotation * Vec3d(of_world.tail<3>());
    const Vec3d shift =
        target_from_world.rotation * Vec3d(of_world.head<3>()) - turn.cross(target_from_world.translation);
    free.push_back((Vec6d() << shift, turn).finished());
  }
  return free;
}

// Two scans from places that differ by distance_m along the world's x axis, a little beside it, and a little rotation.
TrustPair lidar_pair(const Scene& scene, double distance_m, const std::vector<Vec6d>& free_in_world,
                     std::mt19937& generator) {
  const Lidar lidar = some_lidar(generator);
  const double tilt_deg = uniform(generator, 0.0, 3.0);
  const Rigid3 place = scene.world_from_camera * random_motion(generator, tilt_deg * kRadPerDeg, 0.0);
  const double beside_m = uniform(generator, -0.1, 0.1), angle_deg = uniform(generator, 0.5, 2.0);
  const Rigid3 motion{random_motion(generator, angle_deg * kRadPerDeg, 0.0).rotation, {distance_m, beside_m, 0.0}};
  TrustPair pair;
  pair.source = scan_of(scan(scene, lidar, place * motion, some_seed(generator)));
  pair.target = scan_of(scan(scene, lidar, place, some_seed(generator)));
  pair.source.cloud.viewpoint.reset();  // as most files have it
  pair.target.cloud.viewpoint.reset();
  pair.target_from_source = motion;
  pair.free_motions = in_target(free_in_world, place);
  return pair;
}

struct View {
  Rigid3 place;
  double noise = 0.0;  // times the Kinect's
};

Scan seen(const Scene& scene, const View& view, int columns, unsigned seed) {
  const Pinhole camera = testing::kinect_like_camera(columns);
  DepthImage image = testing::render(scene, camera, camera.width, camera.height, view.place).depth;
  if (view.noise > 0.0) testing::add_depth_noise(image, view.noise * testing::kKinectSigmaAt1m, seed);
  return scan_of(image, camera);
}

// A depth camera's two views, free_in_world: motions that leave the scene as it is, about the world's zero.
TrustPair image_pair(const Scene& scene, const std::vector<Vec6d>& free_in_world, std::mt19937& generator) {
  const double noise = drawn_from({1.0, 2.0, 3.0}, generator);
  const int columns = drawn_from({160, 320}, generator);
  const double angle_deg = uniform(generator, 0.0, 3.0), distance_m = uniform(generator, 0.0, 0.1);
  const Rigid3 motion = random_motion(generator, angle_deg * kRadPerDeg, distance_m);
  const Rigid3& place = scene.world_from_camera;
  TrustPair pair;
  pair.source = seen(scene, {place * motion, noise}, columns, some_seed(generator));
  pair.target = seen(scene, {place, noise}, columns, some_seed(generator));
  pair.target_from_source = motion;
  pair.free_motions = in_target(free_in_world, place);
  return pair;
}

TrustPair degenerate_shape(unsigned seed) {
  static constexpr std::size_t kPoints = 6000;
  const auto families = testing::degenerate_families();
  std::mt19937 generator(seed);
  const testing::DegenerateFamily& family = families[generator() % families.size()];
  const double noise = generator() % 2 == 0 ? 0.0 : family.noise;
  const Rigid3 motion = random_motion(generator, 0.03, 0.03);
  TrustPair pair;
  pair.target = scan_of(testing::draw(family, kPoints, noise, generator));
  pair.source = scan_of(transform(testing::draw(family, kPoints, noise, generator), inverse(motion)));
  pair.target_from_source = motion;
  pair.free_motions = family.free_motions;
  return pair;
}

constexpr std::size_t kObjectPoints = 20000;
constexpr double kObjectNoise = 0.0005;

// An object drawn twice, the source moved; angle_deg about any axis through its zero.
TrustPair object_pair(const Object& object, double angle_deg, double noise, std::mt19937& generator) {
  const double distance_m = uniform(generator, 0.0, 0.03);
  const Rigid3 motion = random_motion(generator, angle_deg * kRadPerDeg, distance_m);
  TrustPair pair;
  pair.target = scan_of(sampled(object, kObjectPoints, noise, generator));
  pair.source = scan_of(transform(sampled(object, kObjectPoints, noise, generator), inverse(motion)));
  pair.target_from_source = motion;
  return pair;
}

TrustPair moved_object(unsigned seed) {
  std::mt19937 generator(seed);
  const Object object = one_of(objects(), generator);
  const double angle_deg = uniform(generator, 2.0, 8.0), noise = generator() % 2 ? kObjectNoise : 0.0;
  return object_pair(object, angle_deg, noise, generator);
}

// Only those that look different from everywhere.
TrustPair turned_object(unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<Object> unique;
  for (Object& object : objects())
    if (object.is_unique) unique.push_back(std::move(object));
  const Object object = one_of(unique, generator);
  return object_pair(object, uniform(generator, 60.0, 180.0), kObjectNoise, generator);
}

TrustPair mirrored_object(unsigned seed) {
  std::mt19937 generator(seed);
  std::vector<Object> chiral;
  for (Object& object : objects())
    if (object.is_chiral) chiral.push_back(std::move(object));
  const Object object = one_of(chiral, generator);
  TrustPair pair = object_pair(object, uniform(generator, 0.0, 30.0), kObjectNoise, generator);
  for (Vec3f& point : pair.source.cloud.points) point.y() = -point.y();
  pair.target_from_source.reset();
  return pair;
}

TrustPair unlike_objects(unsigned seed) {
  std::mt19937 generator(seed);
  const auto all = objects();
  const std::size_t first = generator() % all.size();
  const std::size_t second = (first + 1 + generator() % (all.size() - 1)) % all.size();
  TrustPair pair;
  pair.target = scan_of(sampled(all[first], kObjectPoints, kObjectNoise, generator));
  pair.source = scan_of(sampled(all[second], kObjectPoints, kObjectNoise, generator));
  return pair;
}

// A scan of one side on the closed model.
TrustPair part_on_model(unsigned seed) {
  std::mt19937 generator(seed);
  const Object object = one_of(objects(), generator);
  const double angle_deg = uniform(generator, 2.0, 8.0);
  const Rigid3 motion = random_motion(generator, angle_deg * kRadPerDeg, 0.02);
  TrustPair pair;
  pair.target = scan_of(sampled(object, kObjectPoints, 0.0, generator));
  const Vec3d towards_viewer = random_direction(generator);
  const Cloud side = sampled_side(object, kObjectPoints / 2, kObjectNoise, towards_viewer, 1.5, generator);
  pair.source = scan_of(transform(side, inverse(motion)));
  pair.target_from_source = motion;
  return pair;
}

// From a guess that is wrong by half a turn about the vertical, or a little.
TrustPair room_pair(unsigned seed, double angle_deg) {
  std::mt19937 generator(seed);
  const double tilt_deg = uniform(generator, 0.0, 5.0), distance_m = uniform(generator, 0.0, 0.2);
  const Rigid3 about{rotation_exp(Vec3d(0.0, 0.0, angle_deg * kRadPerDeg)), Vec3d::Zero()};
  const Rigid3 motion = about * random_motion(generator, tilt_deg * kRadPerDeg, distance_m);
  TrustPair pair;
  pair.target = scan_of(whole_room(seed, generator));
  pair.source = scan_of(transform(whole_room(seed, generator), inverse(motion)));
  pair.target_from_source = motion;
  return pair;
}

TrustPair half_turned_room(unsigned seed) { return room_pair(seed, 180.0); }

TrustPair mirrored_room(unsigned seed) {
  TrustPair pair = room_pair(seed, 0.0);
  for (Vec3f& point : pair.source.cloud.points) point.y() = -point.y();
  pair.target_from_source.reset();
  return pair;
}

// The outline of a flat part: straight and round pieces, all points with z = 0.
TrustPair flat_outline(unsigned seed) {
  std::mt19937 generator(seed);
  constexpr int kCorners = 7;
  std::vector<Vec3d> corners;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + uniform(generator, -0.3, 0.3)) / kCorners;
    corners.push_back(uniform(generator, 0.4, 1.0) * Vec3d(std::cos(angle), std::sin(angle), 0.0));
  }
  const auto drawn = [&] {
    Cloud cloud;
    for (int i = 0; i < 4000; ++i) {
      const std::size_t k = generator() % kCorners;
      const Vec3d& next = corners[(k + 1) % kCorners];
      cloud.points.push_back((corners[k] + uniform(generator, 0.0, 1.0) * (next - corners[k])).cast<float>());
    }
    return cloud;
  };
  const Rigid3 motion{rotation_exp(Vec3d(0.0, 0.0, uniform(generator, 0.03, 0.12))), {0.02, -0.03, 0.0}};
  TrustPair pair;
  pair.target = scan_of(drawn());
  pair.source = scan_of(transform(drawn(), inverse(motion)));
  pair.target_from_source = motion;
  return pair;
}

// Scenes drawn from the seed, too.
using SceneOf = std::function<Scene(unsigned seed)>;

TrustFamily of_lidar(std::string name, const SceneOf& scene_of, std::vector<Vec6d> free_in_world) {
  const auto draw = [=](unsigned seed) {
    std::mt19937 generator(seed);
    const double distance_m = uniform(generator, 0.3, 1.5);
    return lidar_pair(scene_of(seed), distance_m, free_in_world, generator);
  };
  return {std::move(name), draw, {0.1, 2.0 * kRadPerDeg}};
}

TrustFamily of_camera(std::string name, const SceneOf& scene_of, std::vector<Vec6d> free_in_world) {
  const auto draw = [=](unsigned seed) {
    std::mt19937 generator(seed);
    return image_pair(scene_of(seed), free_in_world, generator);
  };
  return {std::move(name), draw, {0.05, 3.0 * kRadPerDeg}};
}

TrustFamily of_clouds(std::string name, TrustPair (*draw)(unsigned)) {
  return {std::move(name), draw, {0.01, 2.0 * kRadPerDeg}};
}

}  // namespace

std::vector<TrustFamily> trust_families() {
  const Vec3d x = Vec3d::UnitX(), y = Vec3d::UnitY(), z = Vec3d::UnitZ();
  return {of_lidar("lidar corridor", [](unsigned) { return corridor(); }, {along(x)}),
          of_lidar("lidar tunnel", [](unsigned) { return tunnel(); }, {along(x)}),
          of_lidar("lidar colonnade", [](unsigned) { return colonnade(); }, {}),
          of_lidar("lidar field", [](unsigned) { return open_field(); }, {along(x), along(y), about(z)}),
          of_lidar("lidar street", [](unsigned seed) { return street(seed); }, {}),
          of_camera("image corridor", [](unsigned) { return testing::corridor(); }, {along(y)}),
          of_camera("image room", [](unsigned seed) { return testing::room(seed); }, {}),
          of_clouds("bare degenerate shapes", degenerate_shape),
          of_clouds("objects moved", moved_object),
          of_clouds("objects turned", turned_object),
          of_clouds("objects mirrored", mirrored_object),
          of_clouds("objects unlike", unlike_objects),
          of_clouds("part on model", part_on_model),
          {"room half-turned", half_turned_room, {0.05, 3.0 * kRadPerDeg}},
          {"room mirrored", mirrored_room, {0.05, 3.0 * kRadPerDeg}},
          of_clouds("flat outlines", flat_outline)};
}

}  // namespace augicp::synthetic
