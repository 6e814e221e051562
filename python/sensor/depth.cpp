// SPDX-License-Identifier: MIT
#include "python/sensor/depth.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstring>

#include "augicp/io/cloud_file.h"
#include "augicp/io/depth_file.h"
#include "python/bindings.h"
#include "python/core/errors.h"
#include "python/core/numbers.h"
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

constexpr double kMetres = 1.0;  // the scale of values that are metres already

void check_shape(const py::array& image) {
  if (image.ndim() != 2)
    throw std::invalid_argument("depth image: expected shape (height, width), found " + shape_text(image));
  // A side beyond int is refused too: the limit of points is the limit of pixels.
  const auto limit = static_cast<py::ssize_t>(ReadOptions{}.max_points);
  const bool is_too_large = image.shape(0) > limit || image.shape(1) > limit ||
                            (image.shape(1) > 0 && image.shape(0) > limit / image.shape(1));
  if (is_too_large) throw std::invalid_argument("depth image: too large, shape " + shape_text(image));
}

// One value of the converted array, in row-major order.
template <typename Value>
std::vector<Value> values_of(const py::array& given) {
  const auto array = py::array_t<Value, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array) throw py::error_already_set();
  return {array.data(), array.data() + array.size()};
}

bool is_path(const py::object& given) { return py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"); }

DepthImage image_of_file(const py::object& path, std::optional<double> depth_scale) {
  if (!depth_scale)
    throw WrongType(
        "depth image: the path of a file needs depth_scale, the value of one metre: 5000 in the TUM benchmark, 1000 in "
        "most others");
  const auto file = path.cast<std::filesystem::path>();
  return without_gil([&](const std::stop_token&) { return read_depth_png(file, *depth_scale); });
}

std::vector<std::uint16_t> sensor_values(const py::array& image) {
  if (py::dtype::of<std::uint16_t>().equal(image.dtype())) return values_of<std::uint16_t>(image);
  std::vector<std::uint16_t> values;
  for (const std::int64_t value : values_of<std::int64_t>(image)) {
    if (value < 0 || value > 65535)
      throw std::invalid_argument("depth image: expected integers from 0 to 65535, found " + std::to_string(value));
    values.push_back(static_cast<std::uint16_t>(value));
  }
  return values;
}

constexpr const char* kDepthImageReadDoc =
    R"(The depth image in a .png, .pgm or .tif of 16-bit grey values, in a .pfm or .tif of float32, or in an array .npy, as a new
(height, width) float32 array of metres; NaN if there is no reading (0 and 65535).

depth_scale: the value of one metre in integers; 5000 in the TUM benchmark, 1000 in most others. Floats are metres. Raises
FileError for other images, and if the readings show that the scale is wrong by a factor.)";

py::array read_depth(const std::filesystem::path& path, double depth_scale) {
  const DepthImage image = without_gil([&](const std::stop_token&) {
    DepthImage read = read_depth_image(path, depth_scale);
    check_depth_scale(read, path, depth_scale);
    return read;
  });
  return py::array_t<float>({image.height, image.width}, image.depth.data());
}

void write_depth(const std::filesystem::path& path, const py::object& image, double depth_scale) {
  const DepthImage metres = depth_image_from(image, std::nullopt);
  without_gil([&](const std::stop_token&) { write_depth_png(path, metres, depth_scale); });
}

}  // namespace

DepthImage depth_image_from(const py::object& given, std::optional<double> depth_scale) {
  if (is_path(given)) return image_of_file(given, depth_scale);
  const py::array image = as_numbers(given, "depth image");
  check_shape(image);
  const int height = static_cast<int>(image.shape(0)), width = static_cast<int>(image.shape(1));
  if (image.dtype().kind() == 'f')
    return depth_image(values_of<float>(image), width, height, depth_scale.value_or(kMetres));
  if (!depth_scale)
    throw WrongType(
        "depth image: integers need depth_scale, the value of one metre: 5000 in the TUM benchmark, 1000 in "
        "most others");
  return depth_image(sensor_values(image), width, height, *depth_scale);
}

void check_scale(const DepthImage& image, std::optional<double> depth_scale) {
  if (const auto problem = depth_scale_problem(image, depth_scale.value_or(kMetres)))
    throw std::invalid_argument("depth image: " + *problem +
                                (depth_scale ? ". An image of metres needs no depth_scale" : ""));
}

void bind_depth(py::module_& module) {
  module.def("read_depth", &read_depth, py::arg("path"), py::arg("depth_scale"), kDepthImageReadDoc);
  module.def("write_depth", &write_depth, py::arg("path"), py::arg("image"), py::arg("depth_scale"),
             "Writes a (height, width) image of metres as a PNG of 16-bit grey values, round(metres * depth_scale); no "
             "reading, and what does not fit, as 0. Raises FileError.");
}

}  // namespace augicp::python
