// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/eval/evaluate.h"
#include "python/options.h"

namespace augicp::python {

// Every option of evaluate() by its keyword.
const OptionTable<EvaluationOptions>& evaluation_options();

}  // namespace augicp::python
