// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "python/registration/result.h"
#include "python/trust/evidence_state.h"

namespace augicp::python {

// Visitors of parts of a result, see python/core/state.h.
struct VisitIteration {
  void operator()(auto& archive, auto& iteration) const {
    visit_pose(archive, iteration.target_from_source);
    archive.number(iteration.num_pairs);
    archive.number(iteration.cost);
    archive.number(iteration.kernel_chi2);
    archive.number(iteration.lever);
    archive.number(iteration.intensity_information);
  }
};

struct VisitRunnerUp {
  void operator()(auto& archive, auto& other) const {
    visit_pose(archive, other.target_from_source);
    VisitEvidence{}(archive, other.evidence);
  }
};

// All of a result, for pickle and copy: numbers in one float64 array, its options as a dict.
pybind11::tuple state_of_result(const Result& result);

// Throws std::invalid_argument for what state_of_result() did not make.
Result result_of_state(const pybind11::tuple& state);

}  // namespace augicp::python
