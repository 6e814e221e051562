// SPDX-License-Identifier: MIT
#include "python/sensor/camera.h"

#include <pybind11/stl.h>

#include <sstream>
#include <vector>

#include "augicp/io/camera_file.h"
#include "python/bindings.h"
#include "python/core/errors.h"
#include "python/core/numbers.h"
#include "python/core/options.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

constexpr const char* kCameraDoc = R"(A depth camera: pinhole, lens and shutter. It cannot be changed.

Camera(fx, fy, cx, cy), or Camera(K) of a (3, 3) intrinsic matrix with rows fx 0 cx, 0 fy cy, 0 0 1; then width, height,
distortion and readout_s.

Focal lengths and centre in pixels; pixel (0, 0) is the centre of the first one. Camera frame: x right, y down, z forward.
width, height: of its images; 0: any. distortion: the lens's k1 k2 p1 p2 k3, as in OpenCV and ROS ("plumb_bob").
readout_s: rolling shutter: seconds from the readout of the first row to that of the last; 0: all rows at once.

A camera argument may also be text, see Camera.read, or a (3, 3) intrinsic matrix, see Camera.from_matrix. Raises ArgumentError for values out of range.)";

constexpr const char* kCameraReadDoc =
    R"(A camera from text: a known name (see Camera.names), numbers "fx fy cx cy" with or
without the lens "k1 k2 p1 p2 k3" after them, or the path of a file with such numbers, a 3 x 3 intrinsic matrix, or
JSON as Open3D writes it. Raises FileError.)";

DepthCamera of_pinhole(const Pinhole& pinhole, const std::vector<double>& distortion, double readout_s) {
  if (distortion.size() != 5)
    throw std::invalid_argument("distortion: expected the five numbers k1 k2 p1 p2 k3, found " +
                                std::to_string(distortion.size()));
  const std::vector<double>& k = distortion;
  DepthCamera camera{pinhole, {k[0], k[1], k[2], k[3], k[4]}, readout_s};
  if (pinhole.width < 0 || pinhole.height < 0)
    throw std::invalid_argument("width, height: must be at least 0 (0: any)");
  camera.check();
  return camera;
}

// fx 0 cx, 0 fy cy, 0 0 1.
DepthCamera from_matrix(const py::object& matrix, int width, int height, const std::vector<double>& distortion,
                        double readout_s) {
  const py::array numbers = as_reals(as_numbers(matrix, "matrix"));
  if (numbers.ndim() != 2 || numbers.shape(0) != 3 || numbers.shape(1) != 3)
    throw std::invalid_argument("matrix: expected shape (3, 3), found " + shape_text(numbers));
  const Reals at(numbers);
  if (at(0, 1) != 0.0 || at(1, 0) != 0.0 || at(2, 0) != 0.0 || at(2, 1) != 0.0 || at(2, 2) != 1.0)
    throw std::invalid_argument("matrix: expected rows fx 0 cx, 0 fy cy, 0 0 1; cameras with skew are not known");
  return of_pinhole({at(0, 0), at(1, 1), at(0, 2), at(1, 2), width, height}, distortion, readout_s);
}

// Text too, but no array without dimensions.
bool has_length(const py::object& given) {
  const bool has = PyObject_Size(given.ptr()) >= 0;
  PyErr_Clear();
  return has;
}

// fx is the matrix where it stands alone.
DepthCamera made_camera(const py::object& fx, const py::object& fy, const py::object& cx, const py::object& cy,
                        int width, int height, const std::vector<double>& distortion, double readout_s) {
  if (has_length(fx) && !py::isinstance<py::str>(fx) && fy.is_none() && cx.is_none() && cy.is_none())
    return from_matrix(fx, width, height, distortion, readout_s);
  for (const py::object* given : {&fx, &fy, &cx, &cy})
    if (given->is_none() || has_length(*given))
      throw WrongType(
          "Camera: expected the numbers fx, fy, cx and cy, or a (3, 3) matrix alone, with width= and height= by name; "
          "Camera.read() takes text");
  Pinhole pinhole;
  take("fx", fx, pinhole.fx);
  take("fy", fy, pinhole.fy);
  take("cx", cx, pinhole.cx);
  take("cy", cy, pinhole.cy);
  pinhole.width = width;
  pinhole.height = height;
  return of_pinhole(pinhole, distortion, readout_s);
}

std::vector<double> coefficients(const DepthCamera& camera) {
  const auto& [k1, k2, p1, p2, k3] = camera.distortion;
  return {k1, k2, p1, p2, k3};
}

py::tuple arguments_of(const DepthCamera& camera) {
  const auto& [fx, fy, cx, cy, width, height] = camera.pinhole;
  return py::make_tuple(fx, fy, cx, cy, width, height, coefficients(camera), camera.readout_s);
}

std::string camera_in_words(const DepthCamera& camera) {
  const auto& [fx, fy, cx, cy, width, height] = camera.pinhole;
  std::ostringstream text;
  text << "Camera(fx=" << fx << ", fy=" << fy << ", cx=" << cx << ", cy=" << cy << ", width=" << width
       << ", height=" << height;
  if (!camera.distortion.is_none()) text << ", with a lens";
  if (camera.readout_s > 0.0) text << ", readout_s=" << camera.readout_s;
  return text.str() + ")";
}

// An array with two dimensions, or a list of lists.
bool is_matrix(const py::object& given) {
  if (py::isinstance<py::array>(given)) return given.cast<py::array>().ndim() == 2;
  return py::isinstance<py::list>(given) && py::len(given) > 0 && py::isinstance<py::list>(given[py::int_(0)]);
}

}  // namespace

void bind_camera(py::module_& module) {
  const DepthCamera usual;
  py::class_<DepthCamera> type(module, "Camera", kCameraDoc);
  type.def(py::init(&made_camera), py::arg("fx"), py::arg("fy") = py::none(), py::arg("cx") = py::none(),
           py::arg("cy") = py::none(), py::arg("width") = usual.pinhole.width, py::arg("height") = usual.pinhole.height,
           py::arg("distortion") = coefficients(usual), py::arg("readout_s") = usual.readout_s);
  type.def_static(
      "read", [](const std::string& text) { return read_camera(text); }, py::arg("text"), kCameraReadDoc);
  type.def_static(
      "from_matrix", &from_matrix, py::arg("matrix"), py::arg("width") = usual.pinhole.width,
      py::arg("height") = usual.pinhole.height, py::arg("distortion") = coefficients(usual),
      py::arg("readout_s") = usual.readout_s,
      "A camera of a (3, 3) intrinsic matrix with rows fx 0 cx, 0 fy cy, 0 0 1, as OpenCV and Open3D have.");
  type.def_static("names", &camera_names, "Every name that Camera.read knows.");
  const auto pinhole = [&type](const char* name, auto field, const char* doc) {
    type.def_property_readonly(
        name, [field](const DepthCamera& camera) { return camera.pinhole.*field; }, doc);
  };
  pinhole("fx", &Pinhole::fx, "Focal length along x, pixels.");
  pinhole("fy", &Pinhole::fy, "Focal length along y, pixels.");
  pinhole("cx", &Pinhole::cx, "Centre along x, pixels.");
  pinhole("cy", &Pinhole::cy, "Centre along y, pixels.");
  pinhole("width", &Pinhole::width, "Columns of its images; 0: any.");
  pinhole("height", &Pinhole::height, "Rows of its images; 0: any.");
  type.def_property_readonly("distortion", &coefficients, "The lens's k1 k2 p1 p2 k3; all 0: none.");
  type.def_readonly("readout_s", &DepthCamera::readout_s, "Time from the first row to the last, seconds.");
  type.def("__repr__", &camera_in_words);
  type.def(py::pickle(&arguments_of, [](const py::tuple& saved) {
    return py::module_::import("augicp._augicp").attr("Camera")(*saved).cast<DepthCamera>();
  }));
}

DepthCamera camera_from(const py::object& given) {
  if (py::isinstance<DepthCamera>(given)) return given.cast<DepthCamera>();
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
    return read_camera(py::module_::import("os").attr("fspath")(given).cast<std::string>());
  if (is_matrix(given)) return from_matrix(given, 0, 0, coefficients(DepthCamera{}), 0.0);
  throw WrongType("camera: expected an augicp.Camera, text for Camera.read, or a (3, 3) matrix, found " +
                  py::repr(given).cast<std::string>());
}

}  // namespace augicp::python
