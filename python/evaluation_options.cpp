// SPDX-License-Identifier: MIT
#include "python/evaluation_options.h"

#include "augicp/eval/words.h"

namespace augicp::python {

const OptionTable<EvaluationOptions>& evaluation_options() {
  using Options = EvaluationOptions;
  static const OptionTable<Options> table{
      {"align", word<Options>(kAlignments, &Options::alignment)},
      {"truth", word<Options>(kTruthReadings, &Options::truth)},
      {"max_difference_s",
       number<Options>([](auto& options) -> auto& { return options.association.max_difference_s; })},
      {"time_offset_s", number<Options>([](auto& options) -> auto& { return options.association.time_offset_s; })},
      {"delta", number<Options>([](auto& options) -> auto& { return options.delta.delta; })},
      {"unit", word<Options>(
                   kDeltaUnits, [](auto& options) -> auto& { return options.delta.unit; })},
      {"consecutive", number<Options>([](auto& options) -> auto& { return options.delta.consecutive; })},
  };
  return table;
}

}  // namespace augicp::python
