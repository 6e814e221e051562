// SPDX-License-Identifier: MIT
#include "python/cloud/cloud.h"

#include <pybind11/stl.h>

#include "augicp/io/colours.h"
#include "python/bindings.h"
#include "python/cloud/cloud_state.h"
#include "python/cloud/points.h"
#include "python/core/numbers.h"
#include "python/core/without_gil.h"
#include "python/sensor/camera.h"
#include "python/sensor/depth.h"

namespace augicp::python {
namespace {

constexpr const char* kCloudDoc = R"(Points, and what is known of the surface around them. It cannot be changed.

points: (N, 3) array of any real type and strides, metres. It is copied, and may change afterwards. Points that are not
  finite, or beyond 1e18, are dropped with all their attributes; masked points count as not finite.
normals: (N, 3), of any length, or None. Registration uses them instead of estimating its own. Zero: no normal.
structures: (N,) integers, the kind of each normal: 0 none, 1 a plane's normal, 2 an edge's tangent; None: all 1.
viewpoint: (3,), position of the sensor, or None. Normals are oriented towards it.
intensities: (N,), brightness in any unit, NaN if unknown, or None. Registration compares it with intensity=True.
colors: (N, 3), or None: bytes of red, green and blue, or floats from 0 to 1. Registration does not use them; transformed()
  and write() keep them.

Far from zero (UTM coordinates) points are float32 relative to an origin in float64, so no precision is lost.
Raises ArgumentError for wrong shapes and for more than 100 million points, ArgumentTypeError for arrays without numbers.
Objects may be used by several threads at once, and can be pickled. numpy.asarray(cloud) is cloud.points.)";

constexpr const char* kFromDepthDoc = R"(The cloud of a depth image; registration then also uses its pixels.

image: (height, width); 0, negative, NaN and infinite are no reading. Of floats: metres. Of integers up to 65535:
  depth_scale is the value of one metre (5000 in the TUM benchmark, 1000 in most others) and must be given. Or the path of
  a PNG, with depth_scale.
camera: a Camera, or text for Camera.read such as "tum-fr1" or "525 525 319.5 239.5". Its lens is removed.

Frame: the camera's, x right, y down, z forward. Raises ArgumentError if the image's size is not the camera's, and if the
readings show that depth_scale is wrong.)";

ColouredScan from_points(const py::object& points, const py::object& normals, const py::object& structures,
                         const py::object& viewpoint, const py::object& intensities, const py::object& colors) {
  return coloured_scan_of(cloud_from({points, normals, structures, viewpoint, intensities, colors}, "points"));
}

ColouredScan from_depth(const py::object& image, const py::object& camera, std::optional<double> depth_scale) {
  const DepthCamera seen_by = camera_from(camera);
  const DepthImage depth = depth_image_from(image, depth_scale);
  check_scale(depth, depth_scale);
  return without_gil([&](const std::stop_token&) { return ColouredScan(scan_of(depth, seen_by)); });
}

// A new array: origin + point, in float64.
py::array positions(const ColouredScan& scan) {
  py::array_t<double> array({static_cast<py::ssize_t>(scan.cloud.size()), py::ssize_t{3}});
  auto numbers = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i)
    for (int j = 0; j < 3; ++j)
      numbers(i, j) = scan.cloud.origin[j] + static_cast<double>(scan.cloud.points[static_cast<std::size_t>(i)][j]);
  return array;
}

py::object view_of_rows(const py::object& self, const std::vector<Vec3f>& rows) {
  static_assert(sizeof(Vec3f) == 3 * sizeof(float));
  const float* const first = rows.empty() ? nullptr : rows.front().data();
  return view_of(first, {static_cast<py::ssize_t>(rows.size()), 3}, self);
}

py::object directions(const py::object& self) {
  const ColouredScan& scan = self.cast<const ColouredScan&>();
  return scan.cloud.has_directions() ? view_of_rows(self, scan.cloud.directions) : py::none();
}

py::object structures(const py::object& self) {
  const ColouredScan& scan = self.cast<const ColouredScan&>();
  if (!scan.cloud.has_directions()) return py::none();
  const auto* const first = reinterpret_cast<const std::uint8_t*>(scan.cloud.structures.data());
  return view_of(first, {static_cast<py::ssize_t>(scan.cloud.structures.size())}, self);
}

py::object weights(const py::object& self) {
  const ColouredScan& scan = self.cast<const ColouredScan&>();
  if (scan.cloud.weights.empty()) return py::none();
  return view_of(scan.cloud.weights.data(), {static_cast<py::ssize_t>(scan.cloud.weights.size())}, self);
}

py::object intensities(const py::object& self) {
  const ColouredScan& scan = self.cast<const ColouredScan&>();
  if (!scan.cloud.has_intensities()) return py::none();
  return view_of(scan.cloud.intensities.data(), {static_cast<py::ssize_t>(scan.cloud.intensities.size())}, self);
}

py::object colors(const py::object& self) {
  static_assert(sizeof(Colour) == 3);
  const auto& scan = self.cast<const ColouredScan&>();
  if (scan.colours.empty()) return py::none();
  return view_of(scan.colours.front().data(), {static_cast<py::ssize_t>(scan.colours.size()), 3}, self);
}

py::object viewpoint(const ColouredScan& scan) {
  if (!scan.cloud.viewpoint) return py::none();
  return vector_array(Vec3d(scan.cloud.origin + scan.cloud.viewpoint->cast<double>()));
}

py::object image_shape(const ColouredScan& scan) {
  if (!scan.view) return py::none();
  return py::make_tuple(scan.view->index.height, scan.view->index.width);
}

py::object as_numpy(const py::object& self, const py::object& dtype, const py::object& copy) {
  if (!copy.is_none() && !copy.cast<bool>()) throw std::invalid_argument("copy=False: the array must be made");
  py::array array = positions(self.cast<const ColouredScan&>());
  return dtype.is_none() ? array : array.attr("astype")(dtype);
}

ColouredScan transformed(const ColouredScan& scan, const py::object& matrix) {
  return ColouredScan(scan_of(transform(scan.cloud, rigid3_from(matrix, "matrix"))), scan.colours);
}

std::string cloud_in_words(const ColouredScan& scan) {
  std::string text = "Cloud(" + std::to_string(scan.cloud.size()) + " points";
  if (scan.view)
    text += " of a " + std::to_string(scan.view->index.width) + " x " + std::to_string(scan.view->index.height) +
            " depth image";
  return text + (scan.cloud.has_directions() ? ", with directions)" : ")");
}

using CloudType = py::class_<ColouredScan, std::shared_ptr<ColouredScan>>;

void bind_arrays(CloudType& type) {
  type.def_property_readonly("points", &positions, "(N, 3) float64, metres: a new array.");
  type.def_property_readonly(
      "points_from_origin",
      [](const py::object& self) { return view_of_rows(self, self.cast<const ColouredScan&>().cloud.points); },
      "(N, 3) float32, metres, points - origin: the cloud's own memory, read-only, not copied. The array keeps it "
      "alive.");
  type.def_property_readonly(
      "origin", [](const ColouredScan& scan) { return vector_array(scan.cloud.origin); },
      "(3,) float64, metres; zero unless the cloud is far from zero.");
  type.def_property_readonly("directions", &directions,
                             "(N, 3) float32 unit normals and tangents, zero if there is none; None before they are "
                             "estimated. The cloud's own memory, like points_from_origin.");
  type.def_property_readonly("structures", &structures,
                             "(N,) uint8, the kind of each direction: 0 none, 1 a normal, 2 a tangent; or None. The "
                             "cloud's own memory, like points_from_origin.");
  type.def_property_readonly(
      "intensities", &intensities,
      "(N,) float32 view, read-only, in the unit of the file, NaN if unknown; None: the cloud has none.");
  type.def_property_readonly("colors", &colors,
                             "(N, 3) uint8, red, green and blue; or None. The cloud's own memory, like "
                             "points_from_origin.");
  type.def_property_readonly("weights", &weights,
                             "(N,) float32 in (0, 1], weight of each point relative to the best; None: all alike. The "
                             "cloud's own memory, like points_from_origin.");
  type.def_property_readonly("viewpoint", &viewpoint, "(3,) float64, position of the sensor, metres; or None.");
  type.def_property_readonly("image_shape", &image_shape, "(height, width) of its depth image; or None.");
  type.def("__array__", &as_numpy, py::arg("dtype") = py::none(), py::arg("copy") = py::none(), "The same as points.");
}

}  // namespace

void bind_cloud(py::module_& module) {
  CloudType type(module, "Cloud", kCloudDoc);
  type.def(py::init(&from_points), py::arg("points"), py::arg("normals") = py::none(),
           py::arg("structures") = py::none(), py::arg("viewpoint") = py::none(), py::arg("intensities") = py::none(),
           py::arg("colors") = py::none());
  type.def_static("from_depth", &from_depth, py::arg("image"), py::arg("camera"), py::arg("depth_scale") = py::none(),
                  kFromDepthDoc);
  bind_arrays(type);
  type.def(
      "transformed", &transformed, py::arg("matrix"),
      "A new cloud in another frame, with the attributes of all points: matrix is 4 x 4 and maps this frame to that "
      "one. No depth image any more.");
  type.def("__len__", [](const ColouredScan& scan) { return scan.cloud.size(); });
  type.def("__repr__", &cloud_in_words);
  type.def(py::pickle(&state_of, &scan_of_state));
}

SharedScan scan_from(const py::object& given, const std::string& name) {
  if (py::isinstance<ColouredScan>(given)) return given.cast<std::shared_ptr<ColouredScan>>();
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
    return py::module_::import("augicp._augicp").attr("read")(given).cast<std::shared_ptr<ColouredScan>>();
  return std::make_shared<const ColouredScan>(coloured_scan_of(cloud_from({given}, name)));
}

ColouredScan coloured_scan_of(CloudFile file) {
  std::vector<Colour> colours = colours_of(file);
  return ColouredScan(scan_of(std::move(file.cloud)), std::move(colours));
}

py::object cloud_of(Scan scan) { return py::cast(std::make_shared<ColouredScan>(std::move(scan))); }

}  // namespace augicp::python
