// SPDX-License-Identifier: MIT
// Visitors of a result's evidence, see python/core/state.h.
#pragma once

#include "python/core/state.h"

namespace augicp::python {

struct VisitTestimony {
  void operator()(auto& archive, auto& testimony) const {
    archive.number(testimony.knows_free_space);
    archive.number(testimony.contradicting);
    archive.number(testimony.off_planes);
    archive.number(testimony.count.agree);
    archive.number(testimony.count.differ);
    archive.number(testimony.count.conflict);
    archive.number(testimony.count.hidden);
    archive.number(testimony.count.unseen);
  }
};

struct VisitResidualStatistics {
  void operator()(auto& archive, auto& statistics) const {
    archive.number(statistics.count);
    archive.number(statistics.median);
  }
};

struct VisitResiduals {
  void operator()(auto& archive, auto& residuals) const {
    for (auto* kind : {&residuals.point, &residuals.normal, &residuals.tangent})
      VisitResidualStatistics{}(archive, *kind);
  }
};

struct VisitEvidence {
  void operator()(auto& archive, auto& evidence) const {
    VisitTestimony{}(archive, evidence.source_in_target);
    VisitTestimony{}(archive, evidence.target_in_source);
    VisitResiduals{}(archive, evidence.residuals);
    archive.number(evidence.last_step);
    archive.number(evidence.last_rotation_step);
    archive.number(evidence.observability);
    archive.number(evidence.beyond_planes);
    archive.number(evidence.moved);
    archive.number(evidence.outvoted);
  }
};

struct VisitFreeMotion {
  void operator()(auto& archive, auto& motion) const {
    archive.number(motion.kind);
    visit_matrix(archive, motion.axis);
    visit_matrix(archive, motion.point);
    archive.number(motion.pitch);
  }
};

}  // namespace augicp::python
