// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>

#include "python/registration/result.h"

namespace augicp::python {

// How a report names an input: a file by its path, anything else by what it is.
std::string name_in_report(const pybind11::object& given, const ColouredScan& scan);

// Writes the page of `augicp align --report`. Throws std::invalid_argument for a result without its clouds.
void write_report(const Result& result, const std::filesystem::path& path);

}  // namespace augicp::python
