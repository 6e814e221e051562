// SPDX-License-Identifier: MIT
// Eq. (8) and Table 2 the plain way, with explicit matrices and one pair after the other: what the fast way is tested
// against.
#pragma once

#include <span>

#include "augicp/cloud/correspondence.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/objective/linearize.h"

namespace augicp::testing {

// An entry of Table 2 as the matrix it stands for: diag(along, across, across) in a frame whose first axis is the
// direction. A direction of zero has no frame: across times the identity.
Mat3d information_matrix(const Information& information, const Vec3d& direction);

// e_ij of Eq. (8) and its Omega; the linear part of Omega is zero where it has no meaning.
struct PlainPair {
  Vec6d error;
  Mat6d information;
};
PlainPair plain_pair(const Cloud& source, const Cloud& target, const Correspondence& pair,
                     const Rigid3& target_from_source, const InformationModel& model);

// The loss whose derivative is gamma of Eq. (13).
double plain_loss(double chi2, double kernel_chi2);

// Half the sum of the losses of the errors under a pose.
double plain_cost(const PosedPairs& posed, const Objective& objective);

// The same with each pair's Omega as it is under another pose: what a step takes for constant.
double plain_cost(const PosedPairs& posed, const Objective& objective, const Rigid3& pose_of_information);

}  // namespace augicp::testing
