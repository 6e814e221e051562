// SPDX-License-Identifier: MIT
// Frame-to-model registration (scene merging of Serafin and Grisetti, RAS 2017): the average of many frames, in the
// view of one of them, the keyframe. It drifts less than registration to the last frame, because errors do not add up.
#pragma once

#include <vector>

#include "augicp/sensor/scan.h"

namespace augicp {

struct MergeOptions {
  // A reading is merged into the model's point on its line of sight if it is at most this far from it, metres, and the
  // directions agree within this angle, radians.
  double max_distance = 0.05;
  double max_angle = 0.45;

  // Upper limit of the weight of a point's average, in readings of the best weight: old errors fade.
  double max_weight = 50.0;
};

struct LocalModel {
  Scan scan;                   // in the frame of the keyframe's camera, one point per pixel of its view
  std::vector<float> weights;  // of each point's average: the sum over its readings
};

// A model from a single frame. REQUIRES: every frame has a view and directions. Without weights all its points count
// alike.
LocalModel model_of(const Scan& keyframe);

// Merges a registered frame into the model; fills empty pixels of the model's view with the frame's points.
void merge(LocalModel& model, const Scan& frame, const Rigid3& model_from_frame, const MergeOptions& options,
           int num_threads);

// The model in the view of a new keyframe, without the points that the keyframe contradicts or occludes, and with the
// keyframe merged.
LocalModel carried_over(const LocalModel& model, const Scan& keyframe, const Rigid3& keyframe_from_model,
                        const MergeOptions& options, int num_threads);

}  // namespace augicp
