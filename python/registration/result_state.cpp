// SPDX-License-Identifier: MIT
#include "python/registration/result_state.h"

#include "augicp/registration/option_table.h"
#include "python/core/options.h"

namespace augicp::python {
namespace {

template <typename Archive, typename Part>
void visit_certainty(Archive& archive, Part& found) {
  visit_matrix(archive, found.information);
  visit_matrix(archive, found.observability.information);
  visit_matrix(archive, found.observability.directions);
  visit_matrix(archive, found.observability.centroid);
  archive.number(found.observability.gyration);
  if (archive.has(found.covariance)) visit_matrix(archive, *found.covariance);
  archive.size(found.free_motions);
  for (auto& motion : found.free_motions) VisitFreeMotion{}(archive, motion);
}

// Everything but the options and the pairs, which Python does not show.
struct VisitResult {
  void operator()(auto& archive, auto& result) const {
    auto& found = result.found;
    visit_pose(archive, found.target_from_source);
    archive.number(found.status);
    archive.number(found.iterations);
    archive.number(found.num_pairs);
    archive.number(found.num_intensity_pairs);
    archive.number(found.overlap);
    archive.number(found.rmse);
    visit_certainty(archive, found);
    if (archive.has(found.evidence)) VisitEvidence{}(archive, *found.evidence);
    archive.size(found.doubts);
    for (auto& doubt : found.doubts) archive.number(doubt);
    archive.size(found.runners_up);
    for (auto& other : found.runners_up) VisitRunnerUp{}(archive, other);
    archive.size(found.history);
    for (auto& iteration : found.history) VisitIteration{}(archive, iteration);
    visit_matrix(archive, result.reference_point);
  }
};

}  // namespace

py::tuple state_of_result(const Result& result) {
  return state_of_value(result, VisitResult{}, values_of(result.options));
}

Result result_of_state(const py::tuple& state) {
  Result result = value_of_state<Result>(state, VisitResult{});
  set_options(state[2].cast<py::dict>(), result.options);
  return result;
}

}  // namespace augicp::python
