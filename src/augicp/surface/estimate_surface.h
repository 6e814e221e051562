// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/core/words.h"
#include "augicp/surface/neighbourhood.h"
#include "augicp/surface/shape.h"

namespace augicp {

enum class Classifier {
  Normals,      // the default: see line_or_normal() and the steps after it
  Eigenvalues,  // the paper: see shape_of_points()
};
template <>
inline constexpr auto kWords<Classifier> = std::to_array<Word<Classifier>>({{Classifier::Normals, "normals"},
                                                                            {Classifier::Eigenvalues, "eigenvalues"}});

struct SurfaceOptions {
  Classifier classifier = Classifier::Normals;
  ShapeThresholds thresholds;
};

// Section 4.1: estimates the direction and structure of every point from the points near it. Normals point to the
// cloud's viewpoint if that is known. Existing directions are replaced.
void estimate_surface(Cloud& cloud, const Neighbourhood& neighbourhood, const SurfaceOptions& options, int num_threads);

}  // namespace augicp
