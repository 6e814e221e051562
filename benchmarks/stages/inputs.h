// SPDX-License-Identifier: MIT
// What the stages are measured on: images of the sample in data/, and clouds made of them.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "augicp/io/depth_sequence.h"
#include "augicp/registration/registration.h"

namespace augicp::bench {

inline constexpr double kRadius = 0.05;  // of the ball, metres: what registration derives for this desk

const DepthCamera& camera();
std::vector<std::filesystem::path> image_files();
DepthImage raw_image(std::size_t frame);

// Freed of its lens, every step-th pixel of every step-th row.
DepthImage image(std::size_t frame, int step = 1);
OrganizedCloud points(std::size_t frame, int step = 1);

// With directions and structures.
Scan extended(std::size_t frame, int step = 1);

// A new image to extended points, and ten iterations of it to the frame before, which is ready.
class NewFrame {
 public:
  NewFrame(int step, int num_threads);
  AlignResult registered() const;

 private:
  RegistrationOptions options_;
  DepthImage seen_;
  Pinhole pinhole_;
  Scan target_;
  Lengths lengths_;
};

// This many points of the first frames, each moved a little, so that no two are alike.
Cloud cloud_of(std::size_t count);

// Stages that take a number of threads are measured twice: in processor time on one, which does not mind what else the
// machine does, and in wall time on two. Items a second, and how near the stage is to what the machine allows: 1 would
// be as fast as memory and arithmetic can be. Bytes are those that must be read and written once, operations those of
// the formulas; see docs/lab/performance.md.
struct Work {
  double items = 0.0;
  double bytes = 0.0;
  double float_operations = 0.0;  // an operation of doubles counts as two
};
void set_counters(benchmark::State& state, const Work& work);

}  // namespace augicp::bench
