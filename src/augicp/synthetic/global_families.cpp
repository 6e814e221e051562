// SPDX-License-Identifier: MIT
#include "augicp/synthetic/global_families.h"

#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/angles.h"
#include "augicp/experiment/fragments.h"
#include "augicp/experiment/random.h"
#include "augicp/geometry/rotation.h"
#include "augicp/sensor/depth_image.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/objects.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace augicp::synthetic {
namespace {

using testing::Scene;

Vec3d uniform_in(const Vec3d& low, const Vec3d& high, std::mt19937& generator) {
  const double x = uniform(generator, low.x(), high.x()), y = uniform(generator, low.y(), high.y());
  return {x, y, uniform(generator, low.z(), high.z())};
}

struct Room {
  Vec3d size;  // metres
  Scene scene;
};
Room some_room(std::mt19937& generator) {
  const Vec3d size = uniform_in({4.4, 3.2, 2.4}, {8.0, 6.0, 3.2}, generator);
  return {size, testing::room(some_seed(generator), size)};
}

// In the part of the floor that testing::room leaves free, and what is looked at.
struct Gaze {
  Vec3d eye, point;
};
Gaze some_gaze(const Room& room, std::mt19937& generator) {
  constexpr double kMinDistance = 1.0;  // level, metres
  const Vec3d level(room.size.x(), room.size.y(), 1.0);
  for (;;) {
    const Vec3d eye = level.cwiseProduct(uniform_in({0.05, -0.4, 1.2}, {0.2, 0.08, 1.8}, generator));
    const Vec3d point = level.cwiseProduct(uniform_in({-0.45, -0.45, 0.2}, {0.45, 0.45, 1.2}, generator));
    if ((point - eye).head<2>().norm() > kMinDistance) return {eye, point};
  }
}

// Three views side by side, as a turning hand-held depth camera sees them, and the place of the middle one.
struct RoomFragment {
  Cloud cloud;
  Rigid3 world_from_fragment;
};
RoomFragment fragment_of(const Room& room, const Gaze& gaze, std::mt19937& generator) {
  constexpr int kColumns = 160;
  constexpr double kStep_deg = 20.0;
  constexpr std::size_t kPoints = 15000;
  const Pinhole camera = testing::kinect_like_camera(kColumns);
  RoomFragment fragment{{}, testing::look_at(gaze.eye, gaze.point)};
  for (const double angle_deg : {-kStep_deg, 0.0, kStep_deg}) {
    // About the image's y axis.
    const Rigid3 fragment_from_view{rotation_exp(Vec3d(0.0, angle_deg * kRadPerDeg, 0.0)), Vec3d::Zero()};
    DepthImage image = testing::render(room.scene, camera, camera.width, camera.height,
                                       fragment.world_from_fragment * fragment_from_view)
                           .depth;
    testing::add_depth_noise(image, testing::kKinectSigmaAt1m, some_seed(generator));
    for (const Vec3f& in_view : unproject(image, camera).cloud.points)
      fragment.cloud.points.push_back((fragment_from_view * in_view.cast<double>()).cast<float>());
  }
  fragment.cloud = evenly_chosen(fragment.cloud, kPoints);
  return fragment;
}

// The second fragment is seen from elsewhere and shares at least 30 %.
DrawnPair room_pair(unsigned seed) {
  constexpr double kMinOverlap = 0.3, kNear = 0.05;  // metres
  std::mt19937 generator(seed);
  const Room room = some_room(generator);
  for (;;) {
    const RoomFragment target = fragment_of(room, some_gaze(room, generator), generator);
    const RoomFragment source = fragment_of(room, some_gaze(room, generator), generator);
    const Rigid3 truth = inverse(target.world_from_fragment) * source.world_from_fragment;
    if (overlap_of(source.cloud, target.cloud, truth, kNear) >= kMinOverlap) return {source.cloud, target.cloud, truth};
  }
}

DrawnPair rooms_apart(unsigned seed) {
  std::mt19937 generator(seed);
  const auto some_fragment = [&] {
    const Room room = some_room(generator);
    return fragment_of(room, some_gaze(room, generator), generator).cloud;
  };
  Cloud source = some_fragment(), target = some_fragment();
  return {std::move(source), std::move(target), std::nullopt};
}

Cloud side_of(const Object& object, const Vec3d& towards_viewer, std::mt19937& generator) {
  constexpr std::size_t kPoints = 8000;
  constexpr double kNoise = 0.0005, kDistance = 1.5;  // metres
  Cloud side = sampled_side(object, kPoints, kNoise, towards_viewer, kDistance, generator);
  side.viewpoint.reset();  // as most files have it
  return side;
}

// Two sides up to 60 degrees apart of an object that looks different from everywhere.
DrawnPair object_pair(unsigned seed) {
  constexpr double kMaxAngle = 60.0 * kRadPerDeg;
  std::mt19937 generator(seed);
  std::vector<Object> unique;
  for (Object& object : objects())
    if (object.is_unique) unique.push_back(std::move(object));
  const Object& object = unique[generator() % unique.size()];
  const Vec3d towards = random_direction(generator);
  const Vec3d elsewhere = random_motion(generator, uniform(generator, 0.0, kMaxAngle), 0.0).rotation * towards;
  Cloud source = side_of(object, towards, generator), target = side_of(object, elsewhere, generator);
  return {std::move(source), std::move(target), Rigid3{}};
}

// Of two objects of different kinds, up to a third larger or smaller.
DrawnPair objects_apart(unsigned seed) {
  std::mt19937 generator(seed);
  const std::vector<Object> all = objects();
  const std::size_t first = generator() % all.size();
  const std::size_t second = (first + 1 + generator() % (all.size() - 1)) % all.size();
  const auto some_side = [&](const Object& object) {
    Cloud side = side_of(object, random_direction(generator), generator);
    const auto scale = static_cast<float>(uniform(generator, 0.75, 1.33));
    for (Vec3f& point : side.points) point *= scale;
    return side;
  };
  Cloud source = some_side(all[first]), target = some_side(all[second]);
  return {std::move(source), std::move(target), std::nullopt};
}

Lidar street_lidar(std::mt19937& generator) {
  Lidar lidar;
  lidar.num_rings = generator() % 2 == 0 ? 32 : 64;
  lidar.num_azimuths = 900;
  return lidar;
}

// 2 to 10 m along the street, and turned about the vertical by any angle.
DrawnPair street_pair(unsigned seed) {
  std::mt19937 generator(seed);
  const Scene scene = street(some_seed(generator));
  const Lidar lidar = street_lidar(generator);
  const double along = uniform(generator, 2.0, 10.0), beside = uniform(generator, -0.5, 0.5);
  const Vec3d turn(0.0, 0.0, uniform(generator, -180.0, 180.0) * kRadPerDeg);
  const Rigid3 motion{rotation_exp(turn), {along, beside, 0.0}};
  Cloud source = scan(scene, lidar, scene.world_from_camera * motion, some_seed(generator));
  Cloud target = scan(scene, lidar, scene.world_from_camera, some_seed(generator));
  return {std::move(source), std::move(target), motion};
}

DrawnPair streets_apart(unsigned seed) {
  std::mt19937 generator(seed);
  const auto some_scan = [&] {
    const Scene scene = street(some_seed(generator));
    const Lidar lidar = street_lidar(generator);
    return scan(scene, lidar, scene.world_from_camera, some_seed(generator));
  };
  Cloud source = some_scan(), target = some_scan();
  return {std::move(source), std::move(target), std::nullopt};
}

}  // namespace

std::vector<GlobalFamily> global_families() {
  constexpr double kOfObjects = 0.1;  // they are a tenth of a room's size
  return {{"rooms", room_pair},
          {"rooms apart", rooms_apart},
          {"objects", object_pair, kOfObjects},
          {"objects apart", objects_apart, kOfObjects},
          {"streets", street_pair},
          {"streets apart", streets_apart}};
}

}  // namespace augicp::synthetic
