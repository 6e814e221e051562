// SPDX-License-Identifier: MIT
#include "python/cloud/cloud_state.h"

#include <pybind11/stl.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "python/core/numbers.h"

namespace augicp::python {
namespace {

constexpr int kFormat = 3;

void require_sound(bool holds) {
  if (!holds) throw std::invalid_argument("not a pickled augicp.Cloud of this version");
}

template <typename Item>
py::bytes bytes_of(const std::vector<Item>& items) {
  return {reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)};
}

template <typename Item>
std::vector<Item> items_of(const py::handle& bytes) {
  const auto view = py::cast<std::string_view>(bytes);
  require_sound(view.size() % sizeof(Item) == 0);
  std::vector<Item> items(view.size() / sizeof(Item));
  if (!items.empty()) std::memcpy(static_cast<void*>(items.data()), view.data(), view.size());
  return items;
}

py::object state_of_view(const std::optional<Scan::View>& view) {
  if (!view) return py::none();
  const auto& [fx, fy, cx, cy, width, height] = view->camera;
  return py::make_tuple(view->index.width, view->index.height, bytes_of(view->index.index),
                        py::make_tuple(fx, fy, cx, cy, width, height), view->rolling_shutter);
}

Scan::View view_of_state(const py::tuple& state, std::size_t num_points) {
  require_sound(state.size() == 5);
  Scan::View view;
  view.index.width = state[0].cast<int>();
  view.index.height = state[1].cast<int>();
  view.index.index = items_of<std::int32_t>(state[2]);
  const auto camera = state[3].cast<py::tuple>();
  require_sound(camera.size() == 6);
  view.camera = {camera[0].cast<double>(), camera[1].cast<double>(), camera[2].cast<double>(),
                 camera[3].cast<double>(), camera[4].cast<int>(),    camera[5].cast<int>()};
  view.camera.check();
  view.rolling_shutter = state[4].cast<bool>();
  require_sound(view.index.width >= 0 && view.index.height >= 0 &&
                view.index.index.size() == static_cast<std::size_t>(view.index.width) * view.index.height);
  std::size_t next = 0;  // points are in raster order
  for (const std::int32_t index : view.index.index)
    if (index != IndexImage::kNone) require_sound(static_cast<std::size_t>(index) == next++);
  require_sound(next == num_points);
  return view;
}

}  // namespace

py::tuple state_of(const ColouredScan& scan) {
  const Cloud& cloud = scan.cloud;
  py::object viewpoint = py::none();
  if (cloud.viewpoint) viewpoint = py::make_tuple(cloud.viewpoint->x(), cloud.viewpoint->y(), cloud.viewpoint->z());
  return py::make_tuple(kFormat, bytes_of(cloud.points), bytes_of(cloud.directions), bytes_of(cloud.structures),
                        bytes_of(cloud.weights), py::make_tuple(cloud.origin.x(), cloud.origin.y(), cloud.origin.z()),
                        viewpoint, state_of_view(scan.view), bytes_of(cloud.intensities),
                        bytes_of(cloud.intensity_gradients), bytes_of(scan.colours));
}

std::shared_ptr<ColouredScan> scan_of_state(const py::tuple& state) {
  require_sound(state.size() == 11 && state[0].cast<int>() == kFormat);
  const auto scan = std::make_shared<ColouredScan>();
  Cloud& cloud = scan->cloud;
  cloud.points = items_of<Vec3f>(state[1]);
  cloud.directions = items_of<Vec3f>(state[2]);
  cloud.structures = items_of<Structure>(state[3]);
  cloud.weights = items_of<float>(state[4]);
  cloud.intensities = items_of<float>(state[8]);
  cloud.intensity_gradients = items_of<Vec3f>(state[9]);
  scan->colours = items_of<Colour>(state[10]);
  const std::size_t n = cloud.size();
  require_sound(scan->colours.empty() || scan->colours.size() == n);
  require_sound(cloud.intensities.empty() || cloud.intensities.size() == n);
  require_sound(cloud.intensity_gradients.empty() || cloud.intensity_gradients.size() == n);
  require_sound(cloud.directions.size() == cloud.structures.size());
  require_sound(cloud.directions.empty() || cloud.directions.size() == n);
  require_sound(cloud.weights.empty() || cloud.weights.size() == n);
  for (const Structure structure : cloud.structures) require_sound(structure <= Structure::Edge);
  const auto origin = state[5].cast<std::array<double, 3>>();
  cloud.origin = {origin[0], origin[1], origin[2]};
  if (!state[6].is_none()) {
    const auto viewpoint = state[6].cast<std::array<float, 3>>();
    cloud.viewpoint = Vec3f(viewpoint[0], viewpoint[1], viewpoint[2]);
  }
  if (!state[7].is_none()) scan->view = view_of_state(state[7].cast<py::tuple>(), n);
  return scan;
}

}  // namespace augicp::python
