// SPDX-License-Identifier: MIT
// The loop with parts of the default switched off, for ablation.py, which makes the table of docs/lab/convergence.md.
//
//   ablation SOURCE TARGET START [CAMERA]    two files, and a file with the first pose; with a camera: depth images
//   ablation room SEED                       two views of a generated room as clouds, from the identity
//
// Prints lines of a word and poses target_from_source, sixteen numbers each, row by row: the truth if it is known, then
// for each variant the start and the pose after each iteration.
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "augicp/io/camera_file.h"
#include "augicp/io/depth_png.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/transform_file.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"

namespace {

using namespace augicp;

constexpr double kDepthScale = 5000.0;  // of TUM's images
constexpr double kKernelPerRadius = 0.1;
constexpr int kMaxIterations = 60;
constexpr double kLeastStep = 1e-7;

struct Job {
  Scan source, target;
  Rigid3 start;
};

void without_edges(Cloud& cloud) {
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.structures[i] == Structure::Edge) cloud.structures[i] = Structure::None, cloud.directions[i].setZero();
}

RegistrationOptions options_of(Method method) {
  RegistrationOptions options = iterations_alone();
  options.method = method;
  options.max_iterations = kMaxIterations;
  options.min_step = kLeastStep;
  options.covariance = false;
  options.num_threads = 1;
  return options;
}

// The default's numbers with the information of the target, and the gates and kernel that belong to it.
AlignOptions one_sided(const Lengths& lengths, bool projective) {
  AlignOptions align = align_options(lengths, projective, options_of(Method::Plane));
  const AlignOptions usual = align_options(lengths, projective, options_of(Method::Augmented));
  align.information = default_information();
  align.min_kernel_chi2 = usual.min_kernel_chi2;
  align.max_lever = usual.max_lever;
  return align;
}

struct Variant {
  std::string name;
  std::function<void(AlignOptions&)> change;
};

std::vector<Variant> variants(const Lengths& lengths, bool projective) {
  const double kernel = kKernelPerRadius * lengths.radius;
  return {
      {"default", [](AlignOptions&) {}},
      {"no_directions", [](AlignOptions& align) { align.information = positions_only(align.information); }},
      {"one_sided", [=](AlignOptions& align) { align = one_sided(lengths, projective); }},
      {"both_sides", [](AlignOptions& align) { align.information = with_both_sides(align.information); }},
      {"kernel_of_median", [](AlignOptions& align) { align.kernel_chi2.reset(); }},
      {"kernel_constant",
       [=](AlignOptions& align) { align.kernel_chi2 = align.information.planar.position.along * kernel * kernel; }},
      {"lever_of_1_m", [](AlignOptions& align) { align.lever = 1.0; }},
      {"gate_constant", [](AlignOptions& align) { align.gate_per_median = std::numeric_limits<double>::infinity(); }}};
}

void print_pose(const Rigid3& pose) {
  const Mat4d matrix = pose.matrix();
  for (int i = 0; i < 16; ++i) std::printf(" %.9g", matrix(i / 4, i % 4));
}

void print_path(const std::string& name, const ScanPair& pair, const Rigid3& start, const AlignOptions& align_by) {
  const Cloud &source = pair.source.cloud, &target = pair.target.cloud;
  const auto matcher = matcher_for(pair.target, pair.target.view.has_value(), pair.lengths);
  const AlignResult result = align(source, *matcher, without_origins(start, source, target), align_by);
  std::printf("%s", name.c_str());
  print_pose(start);
  for (const AlignIteration& iteration : result.history)
    print_pose(with_origins(iteration.target_from_source, source, target));
  std::printf("\n");
}

void print_variants(Job job) {
  const RegistrationOptions usual = options_of(Method::Augmented);
  PreparedPair pair = prepare_pair(std::move(job.source), std::move(job.target), usual);
  const bool projective = pair.target.view.has_value();
  for (const auto& [name, change] : variants(pair.lengths, projective)) {
    AlignOptions align_by = align_options(pair.lengths, projective, usual);
    change(align_by);
    print_path(name, pair, job.start, align_by);
  }
  without_edges(pair.source.cloud);
  without_edges(pair.target.cloud);
  print_path("no_edges", pair, job.start, align_options(pair.lengths, projective, usual));
}

Job read_job(const std::vector<std::string>& words) {
  const auto read = [&](const std::string& path) {
    if (words.size() < 4) return scan_of(read_cloud(path).cloud);
    return scan_of(read_depth_png(path, kDepthScale), read_camera(words[3]));
  };
  return {read(words[0]), read(words[1]), read_transform(words[2])};
}

Job room_job(unsigned seed) {
  std::mt19937 generator(seed);
  const testing::ScanPair room = testing::room_pair(testing::random_motion(generator, 0.1, 0.1));
  std::printf("truth");
  print_pose(room.target_from_source);
  std::printf("\n");
  return {scan_of(room.source.cloud), scan_of(room.target.cloud), Rigid3{}};
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.size() < 2 || (words.size() == 2) != (words[0] == "room")) {
    std::fprintf(stderr, "usage: ablation SOURCE TARGET START [CAMERA] | ablation room SEED\n");
    return 2;
  }
  print_variants(words[0] == "room" ? room_job(static_cast<unsigned>(std::stoul(words[1]))) : read_job(words));
  return 0;
}
