// SPDX-License-Identifier: MIT
// States of values for pickle and copy. A visitor names the numbers of a value one by one, and serves to write and to
// read them:
//
//   struct VisitSpan {
//     void operator()(auto& archive, auto& span) const { archive.number(span.first); archive.number(span.last); }
//   };
//   type.def(pickled<Span>(VisitSpan{}));
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace augicp::python {

// Of the order of the numbers, of every value; a change of any makes older states unreadable.
constexpr int kStateVersion = 3;

// Counts are exact in a double up to 2^53.
class StateWriter {
 public:
  template <typename Number>
  void number(const Number& value) {
    numbers_.push_back(static_cast<double>(value));
  }
  template <typename Part>
  void size(const std::vector<Part>& parts) {
    number(parts.size());
  }
  template <typename Part>
  bool has(const std::optional<Part>& part) {
    number(part.has_value());
    return part.has_value();
  }
  pybind11::array_t<double> numbers() const {
    return pybind11::array_t<double>(static_cast<pybind11::ssize_t>(numbers_.size()), numbers_.data());
  }

 private:
  std::vector<double> numbers_;
};

// Throws std::invalid_argument where there are too few numbers, or too many.
class StateReader {
 public:
  explicit StateReader(pybind11::array_t<double> numbers) : numbers_(std::move(numbers)) {}

  template <typename Number>
  void number(Number& value) {
    value = static_cast<Number>(next());
  }
  template <typename Part>
  void size(std::vector<Part>& parts) {
    const double count = next();
    if (!(count >= 0.0 && count <= static_cast<double>(numbers_.size()))) refuse();
    parts.resize(static_cast<std::size_t>(count));
  }
  template <typename Part>
  bool has(std::optional<Part>& part) {
    if (next() != 0.0) part.emplace();
    return part.has_value();
  }
  void require_end() const {
    if (at_ != numbers_.size()) refuse();
  }

 private:
  [[noreturn]] static void refuse() { throw std::invalid_argument("this is not the state of a value of augicp"); }
  double next() {
    if (at_ >= numbers_.size()) refuse();
    return numbers_.at(at_++);
  }

  pybind11::array_t<double> numbers_;
  pybind11::ssize_t at_ = 0;
};

template <typename Archive, typename Matrix>
void visit_matrix(Archive& archive, Matrix& matrix) {
  for (auto i = 0 * matrix.size(); i < matrix.size(); ++i) archive.number(matrix.data()[i]);
}

template <typename Archive, typename Pose>
void visit_pose(Archive& archive, Pose& pose) {
  visit_matrix(archive, pose.rotation.coeffs());
  visit_matrix(archive, pose.translation);
}

// The numbers of a value, with the version before them, and back. `rest`: what is no number, empty if all are.
template <typename Value, typename Visit>
pybind11::tuple state_of_value(const Value& value, Visit visit, const pybind11::object& rest = pybind11::none()) {
  StateWriter writer;
  visit(writer, value);
  return pybind11::make_tuple(kStateVersion, writer.numbers(), rest);
}

// Throws std::invalid_argument for what state_of_value() did not make with this visitor.
template <typename Value, typename Visit>
Value value_of_state(const pybind11::tuple& state, Visit visit) {
  if (state.size() != 3 || state[0].cast<int>() != kStateVersion)
    throw std::invalid_argument("this value was pickled by another version of augicp");
  Value value;
  StateReader reader(state[1].cast<pybind11::array_t<double>>());
  visit(reader, value);
  reader.require_end();
  return value;
}

// For a value that is all numbers.
template <typename Value, typename Visit>
auto pickled(Visit visit) {
  return pybind11::pickle([visit](const Value& value) { return state_of_value(value, visit); },
                          [visit](const pybind11::tuple& state) { return value_of_state<Value>(state, visit); });
}

}  // namespace augicp::python
