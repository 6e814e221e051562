// SPDX-License-Identifier: MIT
// Fragments of a room, fused of consecutive depth images by their true poses: A. Zeng et al., "3DMatch: Learning Local
// Geometric Descriptors from RGB-D Reconstructions", CVPR 2017.
#pragma once

#include <vector>

#include "augicp/io/depth_sequence.h"
#include "augicp/sensor/scan.h"

namespace augicp {

struct FragmentOptions {
  std::size_t frames_each = 50;  // at least 1
  std::size_t every = 25;        // frames between the begins of two fragments, at least 1
  int pixel_step = 3;            // every N-th pixel and row of each image, at least 1
  double max_depth = 3.5;        // metres, above 0
  double voxel_size = 0.012;     // of the fused cloud, metres, above 0
  double time_offset_s = 0.0;    // the truth is read at stamp + offset

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

// A bare cloud in the frame of its first camera.
struct Fragment {
  std::size_t first_frame = 0;
  Cloud cloud;
  Rigid3 world_from_fragment;
};

// Images that cannot be read and those without a true pose are left out, and fragments without an image too. Throws
// std::invalid_argument if the sequence has no truth.
std::vector<Fragment> fragments_of(const DepthSequence& sequence, const DepthCamera& camera,
                                   const FragmentOptions& options);

// The share of the source within a distance (metres) of the target under a pose between the clouds' frames, or that of
// the target near the source if that is less. 0 for an empty cloud.
double overlap_of(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, double distance);

}  // namespace augicp
