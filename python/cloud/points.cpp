// SPDX-License-Identifier: MIT
#include "python/cloud/points.h"

#include <optional>
#include <span>
#include <stdexcept>

#include "augicp/io/cloud_from_points.h"
#include "augicp/io/colours.h"
#include "python/core/errors.h"
#include "python/core/numbers.h"
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

std::string hint_for(const py::array& array) {
  if (array.ndim() == 2 && array.shape(0) == 3) return "; is it transposed? Give points.T";
  if (array.ndim() == 2 && array.shape(1) > 3 && array.shape(1) <= 8) return "; give points[:, :3]";
  if (array.ndim() == 2) return "; a depth image? Give augicp.Cloud.from_depth(image, camera)";
  if (array.ndim() == 3 && array.shape(2) == 3) return "; give points.reshape(-1, 3)";
  return "";
}

// Clouds of other packages have their points as an attribute, or as a method.
void refuse_foreign_cloud(const py::object& given, const std::string& name) {
  if (!py::hasattr(given, "points") || py::hasattr(given, "__array__")) return;
  const auto type = py::str(py::type::of(given).attr("__module__")).cast<std::string>() + "." +
                    py::str(py::type::of(given).attr("__name__")).cast<std::string>();
  const bool is_method = PyCallable_Check(given.attr("points").ptr()) != 0;
  throw WrongType(name + ": found " + type + "; give numpy.asarray(" + name + ".points" + (is_method ? "()" : "") +
                  ")");
}

// The size is checked before anything is copied.
py::array rows_of_three(const py::object& given, const std::string& name) {
  refuse_foreign_cloud(given, name);
  const py::array array = as_numbers(given, name);
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw std::invalid_argument(name + ": expected shape (N, 3), found " + shape_text(array) + hint_for(array));
  if (static_cast<std::uint64_t>(array.shape(0)) > ReadOptions{}.max_points)
    throw std::invalid_argument(name + ": " + std::to_string(array.shape(0)) + " points, expected at most " +
                                std::to_string(ReadOptions{}.max_points) + "; thin them first");
  return as_reals(array);
}

std::function<Vec3d(std::size_t)> reader_of(const py::array& array) {
  return [at = Reals(array)](std::size_t i) { return Vec3d(at(i, 0), at(i, 1), at(i, 2)); };
}

void require_count(const py::array& array, py::ssize_t count, const char* name) {
  if (array.shape(0) != count)
    throw std::invalid_argument(std::string(name) + ": expected one for each of the " + std::to_string(count) +
                                " points, found " + std::to_string(array.shape(0)));
}

// (N,), for structures and intensities.
py::array one_a_point(const py::object& given, py::ssize_t count, const char* name) {
  const py::array array = as_numbers(given, name);
  if (array.ndim() != 1)
    throw std::invalid_argument(std::string(name) + ": expected shape (N,), found " + shape_text(array));
  require_count(array, count, name);
  return as_reals(array);
}

// A number that is no structure counts as None, as in files.
Structure structure_of(double number) {
  if (number == static_cast<double>(Structure::Planar)) return Structure::Planar;
  return number == static_cast<double>(Structure::Edge) ? Structure::Edge : Structure::None;
}

std::vector<Colour> checked_colours(const py::object& given, py::ssize_t count) {
  if (given.is_none()) return {};
  const py::array array = as_numbers(given, "colors");
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw std::invalid_argument("colors: expected shape (N, 3), found " + shape_text(array) +
                                (array.ndim() == 2 && array.shape(1) == 4 ? "; give colors[:, :3]" : ""));
  require_count(array, count, "colors");
  const py::array reals = as_reals(array);
  return colours_from(static_cast<std::size_t>(count), array.dtype().kind() == 'f', Reals(reals));
}

}  // namespace

CloudFile cloud_from(const PointArrays& arrays, const std::string& name) {
  const py::array points = rows_of_three(arrays.points, name);
  std::optional<py::array> normals, structures, intensities;  // alive until the end of the work
  PointSource source;
  source.count = static_cast<std::size_t>(points.shape(0));
  source.positions = [at = Reals(points)](std::size_t first, std::span<Vec3d> positions) {
    for (std::size_t k = 0; k < positions.size(); ++k)
      positions[k] = Vec3d(at(first + k, 0), at(first + k, 1), at(first + k, 2));
  };
  if (!arrays.normals.is_none()) {
    normals = rows_of_three(arrays.normals, "normals");
    require_count(*normals, points.shape(0), "normals");
    source.normal = reader_of(*normals);
  }
  if (!arrays.structures.is_none()) {
    if (!normals) throw std::invalid_argument("structures: need the normals that they say the meaning of");
    structures = one_a_point(arrays.structures, points.shape(0), "structures");
    source.structure = [at = Reals(*structures)](std::size_t i) { return structure_of(at(i, 0)); };
  }
  if (!arrays.viewpoint.is_none()) source.viewpoint = vector3_from(arrays.viewpoint, "viewpoint");
  if (!arrays.intensities.is_none()) {
    intensities = one_a_point(arrays.intensities, points.shape(0), "intensities");
    source.intensity = [at = Reals(*intensities)](std::size_t i) { return at(i, 0); };
  }
  const std::vector<Colour> colours = checked_colours(arrays.colors, points.shape(0));
  if (!colours.empty()) source.colour = [&colours](std::size_t i) { return colours[i]; };
  return without_gil([&](const std::stop_token&) { return cloud_from_points(source); });
}

}  // namespace augicp::python
