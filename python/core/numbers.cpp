// SPDX-License-Identifier: MIT
#include "python/core/numbers.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "python/core/errors.h"

namespace augicp::python {
namespace {

bool is_real(const py::dtype& type) { return type.kind() == 'f' || type.kind() == 'i' || type.kind() == 'u'; }

// NumPy's asarray() would reveal masked values.
py::array without_mask(const py::array& array) {
  if (!py::isinstance(array, py::module_::import("numpy.ma").attr("MaskedArray")))
    return py::module_::import("numpy")
        .attr("asarray")(array)
        .cast<py::array>();  // without the overrides of a subclass
  return array.attr("astype")("float64").attr("filled")(std::nan("")).cast<py::array>();
}

py::array as_array(const py::object& given, const std::string& name) {
  if (given.is_none()) throw WrongType(name + ": expected an array of numbers, found None");
  try {
    return py::module_::import("numpy").attr("asanyarray")(given).cast<py::array>();
  } catch (py::error_already_set& error) {
    // Rows of different lengths and the like. An interrupt or a lack of memory passes through.
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw WrongType(name + ": expected an array of numbers: " + py::str(error.value()).cast<std::string>());
  }
}

bool is_native_float(const py::dtype& type) {
  return py::dtype::of<float>().equal(type) || py::dtype::of<double>().equal(type);
}

}  // namespace

py::array as_numbers(const py::object& given, const std::string& name) {
  const py::array array = as_array(given, name);
  if (!is_real(array.dtype()))
    throw WrongType(name + ": expected numbers (float32, float64 or integers), found dtype " +
                    py::str(array.dtype()).cast<std::string>());
  return without_mask(array);
}

py::array as_reals(const py::array& numbers) {
  return is_native_float(numbers.dtype()) ? numbers : numbers.attr("astype")("float64").cast<py::array>();
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")).cast<std::string>(); }

Reals::Reals(const py::array& array)
    : first_(static_cast<const char*>(array.data())),
      row_stride_(array.strides(0)),
      column_stride_(array.ndim() > 1 ? array.strides(1) : 0),
      is_float_(array.itemsize() == sizeof(float)) {}

double Reals::operator()(std::size_t row, std::size_t column) const {
  const char* const place =
      first_ + static_cast<std::ptrdiff_t>(row) * row_stride_ + static_cast<std::ptrdiff_t>(column) * column_stride_;
  if (is_float_) {
    float value;
    std::memcpy(&value, place, sizeof(value));
    return static_cast<double>(value);
  }
  double value;
  std::memcpy(&value, place, sizeof(value));
  return value;
}

Rigid3 rigid3_from(const py::object& matrix, const std::string& name) {
  if (matrix.is_none()) return {};
  const py::array array = as_reals(as_numbers(matrix, name));
  if (array.ndim() != 2 || array.shape(0) != 4 || array.shape(1) != 4)
    throw std::invalid_argument(name + ": expected a 4 x 4 matrix, found shape " + shape_text(array));
  const Reals at(array);
  Mat4d numbers;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) numbers(i, j) = at(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  try {
    return rigid3_from_matrix(numbers);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
  }
}

Vec3d vector3_from(const py::object& numbers, const std::string& name) {
  const py::array array = as_reals(as_numbers(numbers, name));
  if (array.ndim() != 1 || array.shape(0) != 3)
    throw std::invalid_argument(name + ": expected three numbers, found shape " + shape_text(array));
  const Reals at(array);
  const Vec3d vector(at(0, 0), at(1, 0), at(2, 0));
  if (!vector.allFinite()) throw std::invalid_argument(name + ": expected finite numbers");
  return vector;
}

py::array to_array(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  auto numbers = array.mutable_unchecked<2>();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) numbers(i, j) = matrix(i, j);
  return array;
}

py::array vector_array(const Vec3d& vector) { return py::array_t<double>(3, vector.data()); }

py::array to_array(const Rigid3& motion) { return to_array(motion.matrix()); }

}  // namespace augicp::python
