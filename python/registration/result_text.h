// SPDX-License-Identifier: MIT
// Results as people and other programs read them.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "python/registration/result.h"

namespace augicp::python {

// Status, fit and matrix, on several lines: str(result).
std::string text_of(const Result& result);

// The same as HTML, for notebooks.
std::string html_of(const Result& result);

// Lists, numbers and words only: json.dumps() takes it.
pybind11::dict dict_of(const Result& result);

}  // namespace augicp::python
