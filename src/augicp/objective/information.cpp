// SPDX-License-Identifier: MIT
#include "augicp/objective/information.h"

#include "augicp/core/check.h"

namespace augicp {

void InformationModel::check() const {
  for (const StructureInformation* row : {&none, &planar, &edge}) {
    for (const Information& information : {row->position, row->direction}) {
      require_not_negative("information along", information.along);
      require_not_negative("information across", information.across);
    }
  }
}

InformationModel point_information() {
  const StructureInformation isotropic{.position = {1.0, 1.0}, .direction = {}};
  return {isotropic, isotropic, isotropic};
}

InformationModel plane_information() {
  return {.none = {}, .planar = {.position = {1.0, 0.0}, .direction = {}}, .edge = {.position = {0.0, 1.0}, .direction = {}}};
}

InformationModel gicp_information(double epsilon) {
  require_positive("epsilon", epsilon);
  return {.none = {.position = {1.0, 1.0}, .direction = {}},
          .planar = {.position = {1.0 / epsilon, 1.0}, .direction = {}},
          .edge = {.position = {1.0, 1.0 / epsilon}, .direction = {}}};
}

InformationModel augmented_information(double epsilon) { return augmented_information(epsilon, 1.0, 1.0); }

InformationModel augmented_information(double epsilon, double normal_lever_m, double tangent_lever_m) {
  require_not_negative("normal_lever_m", normal_lever_m);
  require_not_negative("tangent_lever_m", tangent_lever_m);
  InformationModel model = gicp_information(epsilon);
  const double normal_scale = normal_lever_m * normal_lever_m, tangent_scale = tangent_lever_m * tangent_lever_m;
  model.planar.direction = {normal_scale, normal_scale / epsilon};
  model.edge.direction = {tangent_scale, tangent_scale / epsilon};
  return model;
}

}  // namespace augicp
