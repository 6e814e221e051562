// SPDX-License-Identifier: MIT
// The library's statuses and kinds, as Python enumerations of their words.
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace augicp::python {

// The member of augicp.<enumeration> with this word.
pybind11::object word_member(const char* enumeration, std::string_view word);

}  // namespace augicp::python
