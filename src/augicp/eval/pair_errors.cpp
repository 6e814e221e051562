// SPDX-License-Identifier: MIT
#include "augicp/eval/pair_errors.h"

#include <map>

namespace augicp {

std::vector<PairError> pair_errors(std::span<const Rigid3> estimate, std::span<const ReferencePair> pairs) {
  std::vector<PairError> errors;
  for (const ReferencePair& pair : pairs) {
    if (pair.first >= estimate.size() || pair.second >= estimate.size()) continue;
    const Rigid3 found = inverse(estimate[pair.first]) * estimate[pair.second];
    const Rigid3 error = inverse(pair.first_from_second) * found;
    errors.push_back({pair, error.translation.norm(), angle_between(error, Rigid3{}),
                      found.translation.norm() - pair.first_from_second.translation.norm()});
  }
  return errors;
}

std::vector<GapError> errors_by_gap(std::span<const PairError> errors) {
  std::map<std::size_t, GapError> of_gap;
  for (const PairError& error : errors) {
    GapError& sum = of_gap[error.pair.second - error.pair.first];
    ++sum.num_pairs;
    sum.length += error.pair.first_from_second.translation.norm();
    sum.translation += error.translation;
    sum.rotation += error.rotation;
    sum.bias += error.bias;
  }
  std::vector<GapError> means;
  for (auto& [gap, mean] : of_gap) {
    mean.gap = gap;
    for (double* value : {&mean.length, &mean.translation, &mean.rotation, &mean.bias})
      *value /= static_cast<double>(mean.num_pairs);
    means.push_back(mean);
  }
  return means;
}

}  // namespace augicp
