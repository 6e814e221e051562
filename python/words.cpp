// SPDX-License-Identifier: MIT
#include "python/words.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "augicp/align/align.h"
#include "augicp/odometry/odometry.h"

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
void add(py::module_& module, const char* name, const char* doc, const std::vector<std::string_view>& words) {
  py::list members;
  for (const std::string_view word : words) members.append(py::make_tuple(in_capitals(word), std::string(word)));
  const py::object base = py::module_::import("augicp._word").attr("Word");
  py::object made = base(name, members, py::arg("module") = "augicp", py::arg("qualname") = name);
  made.attr("__doc__") = doc;
  module.attr(name) = made;
}

template <typename Enumerator>
std::vector<std::string_view> names_up_to(Enumerator last) {
  std::vector<std::string_view> names;
  for (int i = 0; i <= static_cast<int>(last); ++i) names.push_back(name_of(static_cast<Enumerator>(i)));
  return names;
}

}  // namespace

void bind_words(py::module_& module) {
  add(module, "Status",
      "What became of a registration. Only CONVERGED is a pose to trust; DOUBTFUL, DEGENERATE and ITERATION_LIMIT have "
      "one, the others failed. docs/verdict.md says more.",
      names_up_to(AlignStatus::Doubtful));
  add(module, "Doubt",
      "Why a pose is doubted: too few points in reach of the other cloud, too few of them on its surface, too many "
      "where its camera saw through, or nothing but bare planes far from the guess.",
      names_up_to(Doubt::BarePlanes));
  add(module, "MotionKind", "A motion that the data leave open: along an axis, about it, or both at once.",
      names_up_to(FreeMotion::Kind::Screw));
  add(module, "FrameStatus",
      "What became of a frame of odometry. STARTED, TRACKED, DEGENERATE and DOUBTFUL have a pose, the others have "
      "none.",
      names_up_to(FrameStatus::Unreadable));
}

py::object word_member(const char* enumeration, std::string_view word) {
  return py::module_::import("augicp._augicp").attr(enumeration)(std::string(word));
}

}  // namespace augicp::python
