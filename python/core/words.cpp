// SPDX-License-Identifier: MIT
#include "python/core/words.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "augicp/align/align.h"
#include "augicp/odometry/odometry.h"
#include "python/bindings.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

std::string in_capitals(std::string_view word) {
  std::string name(word);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

// Members in the order of the library's enumerators: CONVERGED = "converged".
template <HasWords Value>
void add(py::module_& module, const char* name, const char* doc) {
  py::list members;
  for (const auto& [value, word] : kWords<Value>) members.append(py::make_tuple(in_capitals(word), std::string(word)));
  const py::object base = py::module_::import("augicp._word").attr("Word");
  py::object made = base(name, members, py::arg("module") = "augicp", py::arg("qualname") = name);
  made.attr("__doc__") = doc;
  module.attr(name) = made;
}

}  // namespace

void bind_words(py::module_& module) {
  add<AlignStatus>(
      module, "Status",
      "The outcome of a registration. Only CONVERGED is a pose to trust; DOUBTFUL, AMBIGUOUS, DEGENERATE and "
      "ITERATION_LIMIT have a pose, the others failed. See docs/verdict.md.");
  add<Doubt>(
      module, "Doubt",
      "Why a pose is doubtful: too few points are visible to the other sensor, too few of them are on its surface, too "
      "many are in free space, or only bare planes agree, far from the guess.");
  add<FreeMotion::Kind>(module, "MotionKind",
                        "A motion that the data do not constrain: along an axis, about it, or both.");
  add<FrameStatus>(
      module, "FrameStatus",
      "The outcome of a frame of odometry. STARTED, TRACKED, DEGENERATE and DOUBTFUL have a pose, the others have "
      "none.");
}

py::object word_member(const char* enumeration, std::string_view word) {
  return py::module_::import("augicp._augicp").attr(enumeration)(std::string(word));
}

}  // namespace augicp::python
