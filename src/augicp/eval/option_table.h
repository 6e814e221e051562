// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/core/option.h"
#include "augicp/eval/evaluate.h"

namespace augicp {

// Every option of an evaluation, see core/option.h.
template <OptionsOf<EvaluationOptions> Options, typename Visit>
void for_each_option(Options& options, const Visit& visit) {
  constexpr std::string_view kMatching = "Matching", kErrors = "Errors";
  using enum Unit;
  visit({"max_difference_s", Seconds, kMatching, "Poses whose stamps differ by more are not matched"},
        options.association.max_difference_s);
  visit({"time_offset_s", Seconds, kMatching, "Added to the estimate's stamps"}, options.association.time_offset_s);
  visit({"truth", None, kMatching, "The true pose: nearest in time, or interpolated at the estimate's stamp"},
        options.truth);
  visit({"align", None, kErrors, "How the estimate is aligned with the truth for the second ATE"}, options.alignment);
  visit({"delta", None, kErrors, "RPE compares poses this far apart"}, options.delta.delta);
  visit({"unit", None, kErrors, "Unit of delta; frames: matched poses"}, options.delta.unit);
  visit({"consecutive", None, kErrors, "RPE pairs follow one another, instead of one from every pose"},
        options.delta.consecutive);
}

}  // namespace augicp
