// SPDX-License-Identifier: MIT
#include "augicp/testing/scenes.h"

#include <numbers>
#include <random>
#include <tuple>
#include <utility>

#include "augicp/testing/poses.h"

namespace augicp::testing {
namespace {

// The room's floor is cut into 4 x 3 cells, so that what stands in one touches nothing else. The camera stands in cell
// (3, 0), the table in (1, 1), which leaves (2, 0) and (2, 1) free for the view.
Vec3d cell_center(const Vec3d& room_size, int column, int row) {
  return {room_size.x() * ((column + 0.5) / 4 - 0.5), room_size.y() * ((row + 0.5) / 3 - 0.5), 0.0};
}

// At most 0.8 x 0.7 m: however turned, it stays inside its cell.
void add_furniture(Scene& scene, const Vec3d& base, int ground, std::mt19937& generator) {
  const double yaw_rad = uniform(generator, 0.0, std::numbers::pi);
  const double width = uniform(generator, 0.4, 0.8), depth = uniform(generator, 0.3, 0.7);
  add_standing_box(scene, base, yaw_rad, Vec3d(width, depth, uniform(generator, 0.3, 1.6)), ground);
}

void add_table(Scene& scene, const Vec3d& base, int ground, std::mt19937& generator) {
  const Vec3d slab_size(1.1, 0.8, 0.04);
  const Vec3d slab_center = base + Vec3d(0.0, 0.0, 0.72);
  const BoxFaces slab = add_box(scene, {Eigen::Quaterniond::Identity(), slab_center}, slab_size);
  const Vec3d slab_bottom = slab_center - Vec3d(0.0, 0.0, 0.5 * slab_size.z());
  add_column(scene, {base, slab_bottom, 0.12}, ground, slab.bottom);
  const Vec3d slab_top = slab_center + Vec3d(0.0, 0.0, 0.5 * slab_size.z());
  add_standing_box(scene, slab_top, uniform(generator, 0.2, 1.4), Vec3d(0.3, 0.22, 0.18), slab.top);
}

// A rectangle in a plane of constant y, as seen by a camera that looks along y.
Rectangle upright_rectangle(double y, double left, double right, double bottom, double top) {
  return {{left, y, bottom}, {right - left, 0.0, 0.0}, {0.0, 0.0, top - bottom}};
}

const Vec3d kEye(0.0, 0.0, 1.2);
const Rigid3 kLookingAlongY = look_at(kEye, kEye + Vec3d::UnitY());

}  // namespace

Scene box_on_table() {
  Scene scene;
  const int table = add_surface(scene, Rectangle{{-0.8, -0.5, 0.0}, {1.6, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  add_standing_box(scene, Vec3d::Zero(), 0.5, Vec3d(0.4, 0.3, 0.25), table);
  scene.world_from_camera = look_at({0.3, -1.1, 0.9}, {0.0, 0.0, 0.1});
  return scene;
}

Scene room_corner() {
  Scene scene;
  const Vec3d x(3.0, 0.0, 0.0), y(0.0, 3.0, 0.0), z(0.0, 0.0, 2.6), origin = Vec3d::Zero();
  const int floor = add_surface(scene, Rectangle{origin, x, y});
  const int left = add_surface(scene, Rectangle{origin, y, z});
  const int right = add_surface(scene, Rectangle{origin, x, z});
  scene.creases = {{origin, x, floor, right}, {origin, y, floor, left}, {origin, z, left, right}};
  scene.world_from_camera = look_at({1.7, 1.4, 1.3}, {0.0, 0.0, 0.6});
  return scene;
}

Scene room(unsigned seed, const Vec3d& size) {
  std::mt19937 generator(seed);
  Scene scene;
  const Vec3d center(0.0, 0.0, 0.5 * size.z());
  const BoxFaces walls = add_box(scene, {Eigen::Quaterniond::Identity(), center}, size);
  for (const auto& [column, row] : {std::pair{0, 0}, {1, 0}, {0, 1}, {0, 2}, {2, 2}, {3, 1}})
    add_furniture(scene, cell_center(size, column, row), walls.bottom, generator);
  add_table(scene, cell_center(size, 1, 1), walls.bottom, generator);
  for (const auto& [column, row] : {std::pair{1, 2}, {3, 2}}) {
    const Vec3d base = cell_center(size, column, row) + 0.2 * uniform(generator, -1.0, 1.0) * Vec3d::UnitX();
    const Cylinder shape{base, base + Vec3d(0.0, 0.0, size.z()), uniform(generator, 0.1, 0.25)};
    add_column(scene, shape, walls.bottom, walls.top);
  }
  // Above everything that stands in the left cells.
  const Vec3d pipe_begin(0.3 - 0.5 * size.x(), -0.5 * size.y(), size.z() - 0.3),
      pipe_end(pipe_begin.x(), -pipe_begin.y(), pipe_begin.z());
  add_column(scene, {pipe_begin, pipe_end, 0.06}, walls.front, walls.back);
  scene.world_from_camera = look_at(cell_center(size, 3, 0) + Vec3d(0.2, -0.2, 1.5), Vec3d(-0.9, 0.3, 0.8));
  return scene;
}

Scene wire() {
  Scene scene;
  constexpr double kRadius = 0.005;
  add_surface(scene, upright_rectangle(2.0, -2.0, 0.1, -1.0, 3.0));
  add_wire(scene, {-0.2, 1.0, 0.2}, {-0.2, 1.0, 2.2}, kRadius);
  add_wire(scene, {0.2, 1.0, 0.6}, {0.4, 1.1, 1.8}, kRadius);
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene depth_step() {
  Scene scene;
  add_surface(scene, upright_rectangle(2.0, -3.0, 3.0, -1.0, 4.0));
  add_surface(scene, upright_rectangle(1.6, -0.4, 0.3, 0.9, 1.5));
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene single_plane() {
  Scene scene;
  add_surface(scene, Plane{{0.0, 2.0, 0.0}, Vec3d(0.3, -1.0, 0.2).normalized()});
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene two_parallel_planes() {
  Scene scene;
  add_surface(scene, Plane{{0.0, 2.0, 0.0}, -Vec3d::UnitY()});
  add_surface(scene, upright_rectangle(1.5, -10.0, 0.0, -10.0, 10.0));
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene corridor() {
  Scene scene;
  const Vec3d corner(-1.0, -10.0, 0.0), across(2.0, 0.0, 0.0), along(0.0, 50.0, 0.0), up(0.0, 0.0, 2.5);
  const int floor = add_surface(scene, Rectangle{corner, across, along});
  const int ceiling = add_surface(scene, Rectangle{corner + up, across, along});
  const int left = add_surface(scene, Rectangle{corner, along, up});
  const int right = add_surface(scene, Rectangle{corner + across, along, up});
  for (const auto& [offset, horizontal, vertical] : {std::tuple{Vec3d(Vec3d::Zero()), floor, left},
                                                     {across, floor, right},
                                                     {up, ceiling, left},
                                                     {Vec3d(across + up), ceiling, right}})
    scene.creases.push_back({corner + offset, corner + offset + along, horizontal, vertical});
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene sphere_scene() {
  Scene scene;
  add_surface(scene, Sphere{{0.0, 1.8, 1.2}, 0.5});
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

Scene cylinder_scene() {
  Scene scene;
  add_surface(scene, Cylinder{{0.0, 1.5, -5.0}, {0.0, 1.5, 5.0}, 0.3});
  scene.world_from_camera = kLookingAlongY;
  return scene;
}

}  // namespace augicp::testing
