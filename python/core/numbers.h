// SPDX-License-Identifier: MIT
// Conversion between NumPy's arrays and the library's numbers.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <string>

#include "augicp/geometry/rigid3.h"

namespace augicp::python {

namespace py = pybind11;

// A caller's argument as an array of real numbers of any type and strides; an array is not copied. Masked values become
// NaN. Throws WrongType for everything else (booleans, complex numbers, text, objects, records); name is that of the
// argument.
py::array as_numbers(const py::object& given, const std::string& name);

// The same as float32 or float64 in the byte order of this machine; copied only if needed.
py::array as_reals(const py::array& numbers);

// "(640, 480)"
std::string shape_text(const py::array& array);

// The numbers of an array by their indices, for any strides and alignment. It only reads memory, so it needs no GIL.
// REQUIRES: the array outlives it.
class Reals {
 public:
  explicit Reals(const py::array& array);
  double operator()(std::size_t row, std::size_t column) const;

 private:
  const char* first_;
  std::ptrdiff_t row_stride_, column_stride_;
  bool is_float_;
};

// A rigid motion from a 4 x 4 matrix; None: the identity. Throws WrongType or std::invalid_argument.
Rigid3 rigid3_from(const py::object& matrix, const std::string& name);

// Three finite numbers. Throws WrongType or std::invalid_argument.
Vec3d vector3_from(const py::object& numbers, const std::string& name);

// New arrays of float64.
py::array to_array(const Eigen::Ref<const Eigen::MatrixXd>& matrix);
py::array vector_array(const Vec3d& vector);
py::array to_array(const Rigid3& motion);

// A read-only view of memory of owner, without a copy. It keeps owner alive. REQUIRES: the memory does not change.
template <typename Number>
py::array view_of(const Number* first, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array_t<Number> view(std::move(shape), first, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

}  // namespace augicp::python
