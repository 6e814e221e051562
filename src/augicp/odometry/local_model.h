// SPDX-License-Identifier: MIT
// Frame-to-model (Serafin and Grisetti's scene merging, RAS 2017): what many frames saw, averaged in the view of one of
// them, the keyframe. Registering to it drifts less than registering to the last frame, whose noise is its own.
#pragma once

#include <vector>

#include "augicp/sensor/scan.h"

namespace augicp {

struct MergeOptions {
  // A reading is averaged into the model's point on its line of sight if it is no farther from it than this, metres,
  // and both directions agree within this angle, radians.
  double max_distance = 0.05;
  double max_angle = 0.45;

  // A point's average never counts more than so many best readings: old errors fade.
  double max_weight = 50.0;
};

struct LocalModel {
  Scan scan;                   // in the frame of the keyframe's camera, one point a pixel of its view
  std::vector<float> weights;  // of each point's average: the sum over its readings
};

// A model that a single frame saw. Every frame must have a view and directions; without weights all its points count
// alike.
LocalModel model_of(const Scan& keyframe);

// Averages a registered frame into the model; where the model's view has nothing yet, the frame's points are added.
void merge(LocalModel& model, const Scan& frame, const Rigid3& model_from_frame, const MergeOptions& options,
           int num_threads);

// The model seen from a new keyframe, without what that proves wrong or cannot see, and with the keyframe merged.
LocalModel carried_over(const LocalModel& model, const Scan& keyframe, const Rigid3& keyframe_from_model,
                        const MergeOptions& options, int num_threads);

}  // namespace augicp
