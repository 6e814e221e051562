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
      "What became of a registration. Only CONVERGED is a pose to trust; DOUBTFUL, DEGENERATE and ITERATION_LIMIT have "
      "one, the others failed. docs/verdict.md says more.");
  add<Doubt>(
      module, "Doubt",
      "Why a pose is doubted: too few points in reach of the other cloud, too few of them on its surface, too many "
      "where its camera saw through, or nothing but bare planes far from the guess.");
  add<FreeMotion::Kind>(module, "MotionKind",
                        "A motion that the data leave open: along an axis, about it, or both at once.");
  add<FrameStatus>(
      module, "FrameStatus",
      "What became of a frame of odometry. STARTED, TRACKED, DEGENERATE and DOUBTFUL have a pose, the others have "
      "none.");
}

py::object word_member(const char* enumeration, std::string_view word) {
  return py::module_::import("augicp._augicp").attr(enumeration)(std::string(word));
}

}  // namespace augicp::python
