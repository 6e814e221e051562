// SPDX-License-Identifier: MIT
#include "python/registration/result_state.h"

#include <pybind11/numpy.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "augicp/registration/option_table.h"
#include "python/core/options.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

constexpr int kStateVersion = 2;

// A part is visited as one list of numbers, in the same order for writing and reading. Counts are exact in a double up
// to 2^53.
class Writer {
 public:
  std::vector<double> numbers;

  template <typename Number>
  void number(const Number& value) {
    numbers.push_back(static_cast<double>(value));
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
};

class Reader {
 public:
  explicit Reader(const py::array_t<double>& numbers) : numbers_(numbers) {}

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
  [[noreturn]] static void refuse() { throw std::invalid_argument("this is not the state of an augicp.Result"); }
  double next() {
    if (at_ >= numbers_.size()) refuse();
    return numbers_.at(at_++);
  }

  const py::array_t<double>& numbers_;
  py::ssize_t at_ = 0;
};

template <typename Archive, typename Matrix>
void visit_matrix(Archive& archive, Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) archive.number(matrix.data()[i]);
}

template <typename Archive, typename Pose>
void visit_pose(Archive& archive, Pose& pose) {
  visit_matrix(archive, pose.rotation.coeffs());
  visit_matrix(archive, pose.translation);
}

template <typename Archive, typename Part>
void visit_counts(Archive& archive, Part& agreement) {
  archive.number(agreement.agree);
  archive.number(agreement.differ);
  archive.number(agreement.conflict);
  archive.number(agreement.hidden);
  archive.number(agreement.unseen);
}

template <typename Archive, typename Part>
void visit_testimony(Archive& archive, Part& testimony) {
  archive.number(testimony.knows_free_space);
  archive.number(testimony.contradicting);
  archive.number(testimony.off_planes);
  visit_counts(archive, testimony.count);
}

template <typename Archive, typename Part>
void visit_evidence(Archive& archive, Part& evidence) {
  visit_testimony(archive, evidence.source_in_target);
  visit_testimony(archive, evidence.target_in_source);
  for (auto* kind : {&evidence.residuals.point, &evidence.residuals.normal, &evidence.residuals.tangent}) {
    archive.number(kind->count);
    archive.number(kind->median);
  }
  archive.number(evidence.last_step);
  archive.number(evidence.last_rotation_step);
  archive.number(evidence.observability);
  archive.number(evidence.beyond_planes);
  archive.number(evidence.moved);
}

template <typename Archive, typename Part>
void visit_iteration(Archive& archive, Part& iteration) {
  visit_pose(archive, iteration.target_from_source);
  archive.number(iteration.num_pairs);
  archive.number(iteration.cost);
  archive.number(iteration.kernel_chi2);
  archive.number(iteration.lever);
  archive.number(iteration.intensity_information);
}

template <typename Archive, typename Part>
void visit_motion(Archive& archive, Part& motion) {
  archive.number(motion.kind);
  visit_matrix(archive, motion.axis);
  visit_matrix(archive, motion.point);
  archive.number(motion.pitch);
}

template <typename Archive, typename Part>
void visit_certainty(Archive& archive, Part& result) {
  visit_matrix(archive, result.information);
  visit_matrix(archive, result.observability.information);
  visit_matrix(archive, result.observability.directions);
  visit_matrix(archive, result.observability.centroid);
  archive.number(result.observability.gyration);
  if (archive.has(result.covariance)) visit_matrix(archive, *result.covariance);
  archive.size(result.free_motions);
  for (auto& motion : result.free_motions) visit_motion(archive, motion);
}

// Everything but the pairs, which Python does not show.
template <typename Archive, typename Part>
void visit_result(Archive& archive, Part& result) {
  visit_pose(archive, result.target_from_source);
  archive.number(result.status);
  archive.number(result.iterations);
  archive.number(result.num_pairs);
  archive.number(result.num_intensity_pairs);
  archive.number(result.overlap);
  archive.number(result.rmse);
  visit_certainty(archive, result);
  if (archive.has(result.evidence)) visit_evidence(archive, *result.evidence);
  archive.size(result.doubts);
  for (auto& doubt : result.doubts) archive.number(doubt);
  archive.size(result.runners_up);
  for (auto& other : result.runners_up) {
    visit_pose(archive, other.target_from_source);
    visit_evidence(archive, other.evidence);
  }
  archive.size(result.history);
  for (auto& iteration : result.history) visit_iteration(archive, iteration);
}

}  // namespace

py::tuple state_of_result(const Result& result) {
  Writer writer;
  visit_result(writer, result.found);
  visit_matrix(writer, result.reference_point);
  return py::make_tuple(kStateVersion,
                        py::array_t<double>(static_cast<py::ssize_t>(writer.numbers.size()), writer.numbers.data()),
                        values_of(result.options));
}

Result result_of_state(const py::tuple& state) {
  if (state.size() != 3 || state[0].cast<int>() != kStateVersion)
    throw std::invalid_argument("this Result was pickled by another version of augicp");
  Result result;
  const auto numbers = state[1].cast<py::array_t<double>>();
  Reader reader(numbers);
  visit_result(reader, result.found);
  visit_matrix(reader, result.reference_point);
  reader.require_end();
  set_options(state[2].cast<py::dict>(), result.options);
  return result;
}

}  // namespace augicp::python
