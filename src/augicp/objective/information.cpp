// SPDX-License-Identifier: MIT
#include "augicp/objective/information.h"

#include <stdexcept>

#include "augicp/core/check.h"

namespace augicp {
namespace {

void require_covariance(const Information& information) {
  require_positive("information along, from both sides", information.along);
  require_positive("information across, from both sides", information.across);
}

}  // namespace

void InformationModel::check() const {
  if (direction_sides == Sides::TargetGaussian)
    throw std::invalid_argument("direction_sides: directions have no Gaussian");
  for (const StructureInformation* row : {&none, &planar, &edge}) {
    for (const Information& information : {row->position, row->direction}) {
      require_not_negative("information along", information.along);
      require_not_negative("information across", information.across);
    }
    if (position_sides == Sides::Both) require_covariance(row->position);
    const bool is_compared = row->direction.along > 0.0 || row->direction.across > 0.0;
    if (direction_sides == Sides::Both && is_compared) require_covariance(row->direction);
  }
}

InformationModel point_information() {
  const StructureInformation isotropic{.position = {1.0, 1.0}, .direction = {}};
  return {isotropic, isotropic, isotropic};
}

InformationModel plane_information() {
  return {.none = {},
          .planar = {.position = {1.0, 0.0}, .direction = {}},
          .edge = {.position = {0.0, 1.0}, .direction = {}}};
}

InformationModel gicp_information(double epsilon) {
  require_positive("epsilon", epsilon);
  return {.none = {.position = {1.0, 1.0}, .direction = {}},
          .planar = {.position = {1.0 / epsilon, 1.0}, .direction = {}},
          .edge = {.position = {1.0, 1.0 / epsilon}, .direction = {}}};
}

InformationModel augmented_information(double epsilon) {
  InformationModel model = gicp_information(epsilon);
  model.planar.direction = model.edge.direction = {1.0, 1.0 / epsilon};
  return model;
}

InformationModel default_information(double epsilon) {
  InformationModel model = augmented_information(epsilon);
  model.edge.position = model.none.position;
  return model;
}

InformationModel with_both_sides(const InformationModel& model) {
  InformationModel both = model;
  both.position_sides = Sides::Both;
  return both;
}

InformationModel ndt_information(double epsilon) {
  InformationModel model = gicp_information(epsilon);
  model.position_sides = Sides::TargetGaussian;
  return model;
}

InformationModel with_lever(const InformationModel& model, double lever_m) {
  require_not_negative("lever_m", lever_m);
  InformationModel scaled = model;
  for (StructureInformation* row : {&scaled.none, &scaled.planar, &scaled.edge}) {
    row->direction.along *= lever_m * lever_m;
    row->direction.across *= lever_m * lever_m;
  }
  return scaled;
}

}  // namespace augicp
