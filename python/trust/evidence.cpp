// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <sstream>

#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/words.h"
#include "python/registration/result.h"
#include "python/trust/evidence_state.h"

namespace augicp::python {
namespace {

void bind_free_motion(py::module_& module) {
  py::class_<FreeMotion> type(module, "FreeMotion", "A motion of the source that changes nothing in what was seen.");
  type.def_property_readonly(
      "kind", [](const FreeMotion& motion) { return word_member("MotionKind", name_of(motion.kind)); },
      "A MotionKind.");
  type.def_property_readonly(
      "axis", [](const FreeMotion& motion) { return vector_array(motion.axis); },
      "(3,) unit vector in the target's frame; it and its opposite are the same.");
  type.def_property_readonly(
      "point", [](const FreeMotion& motion) { return vector_array(motion.point); },
      "(3,) a point on the axis in the target's frame, metres.");
  type.def_readonly("pitch", &FreeMotion::pitch, "Metres along the axis for each radian about it, of a screw.");
  type.def("__repr__", [](const FreeMotion& motion) {
    std::ostringstream text;
    text << "<augicp.FreeMotion " << name_of(motion.kind) << " axis (" << motion.axis.transpose() << ")>";
    return text.str();
  });
  type.def(pickled<FreeMotion>(VisitFreeMotion{}));
}

std::string evidence_in_words(const Testimony& testimony) {
  std::ostringstream text;
  text << "<augicp.Testimony of " << testimony.count.total() << " points: seen " << testimony.seen() << ", agreeing "
       << testimony.agreeing() << ", conflicting " << testimony.conflicting() << ", contradicting "
       << testimony.contradicting << ">";
  return text.str();
}

std::string evidence_in_words(const Residuals& residuals) {
  std::ostringstream text;
  text << "<augicp.Residuals median point " << residuals.point.median << " m, normal " << residuals.normal.median
       << " rad, tangent " << residuals.tangent.median << " rad>";
  return text.str();
}

std::string evidence_in_words(const Evidence& evidence) {
  std::ostringstream text;
  text << "<augicp.Evidence strain " << strain(evidence) << ", seen " << evidence.source_in_target.seen() << " and "
       << evidence.target_in_source.seen() << ", agreeing " << evidence.source_in_target.agreeing() << " and "
       << evidence.target_in_source.agreeing() << ">";
  return text.str();
}

void bind_testimony(py::module_& module) {
  py::class_<Testimony> type(module, "Testimony", "What one cloud shows of the other, as shares from 0 to 1.");
  type.def_property_readonly("seen", &Testimony::seen, "Share of all points that the other sensor should see.");
  type.def_property_readonly("agreeing", &Testimony::agreeing, "Share of those on a surface with an agreeing normal.");
  type.def_property_readonly("conflicting", &Testimony::conflicting,
                             "Share of those in free space of the other's camera.");
  type.def_property_readonly(
      "num_points", [](const Testimony& testimony) { return testimony.count.total(); }, "Points that were compared.");
  type.def_readonly("knows_free_space", &Testimony::knows_free_space, "It is a depth image.");
  type.def_readonly("contradicting", &Testimony::contradicting,
                    "Share, from 0 to 1, of the largest part that leaves the other's surface where that goes on.");
  type.def_readonly(
      "off_planes", &Testimony::off_planes,
      "How well points off the large planes agree, divided by how well those on them do; 1 if not asked.");
  type.def("__repr__", [](const Testimony& testimony) { return evidence_in_words(testimony); });
  type.def(pickled<Testimony>(VisitTestimony{}));
}

void bind_residuals(py::module_& module) {
  py::class_<ResidualStatistics> statistics(module, "ResidualStatistics", "The typical size of one kind of residual.");
  statistics.def_readonly("count", &ResidualStatistics::count, "Pairs with this residual.");
  statistics.def_readonly("median", &ResidualStatistics::median, "Metres or radians; 0 if there is none.");
  statistics.def("__repr__", [](const ResidualStatistics& kind) {
    std::ostringstream text;
    text << "<augicp.ResidualStatistics median " << kind.median << " of " << kind.count << " pairs>";
    return text.str();
  });
  statistics.def(pickled<ResidualStatistics>(VisitResidualStatistics{}));
  py::class_<Residuals> residuals(module, "Residuals", "Residuals of each measured quantity under the pose.");
  residuals.def_readonly("point", &Residuals::point, "Distances from the target's planes, metres.");
  residuals.def_readonly("normal", &Residuals::normal, "Angles between normals, radians.");
  residuals.def_readonly("tangent", &Residuals::tangent, "Angles between tangents, radians.");
  residuals.def("__repr__", [](const Residuals& kinds) { return evidence_in_words(kinds); });
  residuals.def(pickled<Residuals>(VisitResiduals{}));
}

}  // namespace

void bind_evidence(py::module_& module) {
  bind_free_motion(module);
  bind_testimony(module);
  bind_residuals(module);
  py::class_<Evidence> type(module, "Evidence", "Evidence for and against a pose; docs/verdict.md.");
  type.def_readonly("source_in_target", &Evidence::source_in_target,
                    "What the target shows of the source: a Testimony.");
  type.def_readonly("target_in_source", &Evidence::target_in_source,
                    "What the source shows of the target: a Testimony.");
  type.def_readonly("residuals", &Evidence::residuals, "Residuals of the final pairs.");
  type.def_readonly("beyond_planes", &Evidence::beyond_planes,
                    "Share, from 0 to 1, of the points that agree off the three largest planes.");
  type.def_readonly("moved", &Evidence::moved,
                    "RMS motion of the source from the guess, divided by its radius of gyration.");
  type.def_readonly("outvoted", &Evidence::outvoted,
                    "How many times as many pairs of points that look alike support a clearly different pose; 0 where "
                    "that was not asked, near the guess.");
  type.def_property_readonly(
      "strain", [](const Evidence& evidence) { return strain(evidence); },
      "The largest ratio of a value to its limit; above 1 the pose is doubtful.");
  type.def("__repr__", [](const Evidence& evidence) { return evidence_in_words(evidence); });
  type.def(pickled<Evidence>(VisitEvidence{}));
}

}  // namespace augicp::python
