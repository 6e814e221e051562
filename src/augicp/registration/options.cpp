// SPDX-License-Identifier: MIT
#include "augicp/registration/options.h"

#include <limits>
#include <numbers>
#include <stdexcept>

#include "augicp/core/check.h"
#include "augicp/registration/voxel_radius.h"

namespace augicp {
namespace {

// The lever may not exceed this many radii of the ball: farther apart than about a ball, what a pair's directions say
// of the rotation is no better than what curvature and wrong pairs make of them. Chosen on fr1/desk.
constexpr double kLeverPerRadius = 1.4;

// A nearest neighbour is near by construction, right or wrong, so that the gate must close where scans overlap in part
// (redkitchen, generated rooms). A pair on a line of sight may be far apart though right: closing its gate cost half of
// the large motions on fr1/desk.
constexpr double kGatePerMedianNearest = 4.0;

// With steps as long as this a mug, whose handle alone holds its turn, ends within the limit of iterations. It took
// 200.
constexpr double kMaxStretch = 16.0;

// Information from both sides lets the clouds meet in two or three iterations, so that the gate may close to what
// remains between two samples of a surface: 1.2 voxels. (Chosen on the LiDAR pair and the car: farther pairs are those
// that only one scan saw, and no kernel discounts them.)
constexpr double kGatePerMedianOfBoth = 2.0;
constexpr double kMinGatePerRadiusOfBoth = 0.3;

constexpr double kMinKernelPerRadius = 0.01;

// Known pairs, chosen on seeds 1 to 4 of Table 4: with 99 % of false pairs a hundredth of all is true. Below five
// hundredths of the radius off a plane K only takes weight from true pairs.
constexpr double kKnownPairsQuantile = 0.01;
constexpr double kMinKernelPerRadiusOfKnownPairs = 0.05;

// Two points share a part of the neighbours from which their directions come up to two radii apart.
constexpr double kCorrelationPerRadius = 2.0;

// The paper gives no K. 1 is 3.2 cm off a plane under Table 2, in the middle of the range that works on depth images.
constexpr double kPaperKernelChi2 = 1.0;

// K where the positions are off a plane by this.
double kernel_at(double distance, const AlignOptions& align) {
  return align.information.planar.position.along * distance * distance;
}

// Plane and point have no covariance to add to another.
bool has_both_sides(const RegistrationOptions& options) {
  return options.preset == Preset::Default && (options.method == Method::Augmented || options.method == Method::Gicp);
}

// Pairs of nearest neighbours. A camera's directions err less than its pairs do: there both sides gained nothing
// (docs/lab/convergence.md).
void weigh_both_sides(const Lengths& lengths, AlignOptions& align) {
  align.information = with_both_sides(align.information);
  align.kernel_chi2 = std::numeric_limits<double>::infinity();
  align.gate_per_median = kGatePerMedianOfBoth;
  align.min_max_distance = kMinGatePerRadiusOfBoth * lengths.radius;
}

}  // namespace

void RegistrationOptions::check() const {
  if (radius) require_positive("radius", *radius);
  if (voxel_size) require_positive("voxel_size", *voxel_size);
  if (max_distance) require(*max_distance > 0.0, "max_distance", *max_distance, "must be above 0");
  require(max_angle > 0.0, "max_angle", max_angle, "must be above 0");
  require(max_angle <= std::numbers::pi, "max_angle", max_angle, "must be at most pi; it is in radians, not degrees");
  if (kernel_chi2) require_positive("kernel_chi2", *kernel_chi2);
  if (lever) require_not_negative("lever", *lever);
  if (damping) require_not_negative("damping", *damping);
  if (max_memory_gb) require(*max_memory_gb > 0.0, "max_memory_gb", *max_memory_gb, "must be above 0");
  require(max_iterations > 0, "max_iterations", max_iterations, "must be at least 1");
  require_not_negative("min_step", min_step);
  if (global && preset == Preset::Paper)
    throw std::invalid_argument("global: the paper's preset iterates from the guess alone; use another preset");
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

RegistrationOptions iterations_alone() {
  RegistrationOptions options;
  options.search = options.coarse_to_fine = options.rolling_shutter = false;
  return options;
}

Lengths lengths_for(const Scan& source, const Scan& target, const RegistrationOptions& options) {
  Lengths lengths = derive_lengths(source, target, options.num_threads);
  if (options.radius)
    lengths.radius = *options.radius;
  else if (options.voxel_size)
    lengths.radius = radius_for(*options.voxel_size, source, target, lengths, options.num_threads);
  lengths.voxel_size = options.voxel_size.value_or(voxel_size_for(lengths.radius));
  lengths.max_distance = options.max_distance.value_or(lengths.max_distance);
  return lengths;
}

InformationModel information_for(const RegistrationOptions& options, double epsilon) {
  const InformationModel model =
      options.preset == Preset::Paper ? augmented_information(epsilon) : default_information(epsilon);
  switch (options.method) {
    case Method::Augmented:
      return model;
    case Method::Gicp:
      return positions_only(model);
    case Method::Plane:
      return plane_information();
    case Method::Point:
      return point_information();
    case Method::Ndt:
      return gicp_information(epsilon);  // of the search's wide stage, see align_options()
  }
  return model;
}

SurfaceOptions surface_options(const RegistrationOptions& options) {
  SurfaceOptions surface;
  surface.classifier =
      options.classifier.value_or(options.preset == Preset::Paper ? Classifier::Eigenvalues : Classifier::Normals);
  return surface;
}

AlignOptions align_options(const Lengths& lengths, bool projective, const RegistrationOptions& options) {
  AlignOptions align;
  align.information = options.method == Method::Ndt ? ndt_information() : information_for(options);
  align.gates.max_distance = lengths.max_distance;
  align.gates.max_angle = options.max_angle;
  if (options.preset == Preset::Default && !projective) {
    align.gate_per_median = kGatePerMedianNearest;
    align.min_max_distance = lengths.radius;
    align.max_stretch = kMaxStretch;
  }
  if (!projective && has_both_sides(options)) weigh_both_sides(lengths, align);
  align.min_kernel_chi2 = kernel_at(kMinKernelPerRadius * lengths.radius, align);
  align.max_lever = kLeverPerRadius * lengths.radius;
  if (options.preset == Preset::Paper) {
    align.lever = 1.0;
    align.kernel_chi2 = kPaperKernelChi2;
    align.kernel_direction_per_median = std::numeric_limits<double>::infinity();
  }
  if (options.lever) align.lever = options.lever;
  if (options.kernel_chi2) align.kernel_chi2 = options.kernel_chi2;
  align.intensity_weight = options.intensity ? 1.0 : 0.0;
  align.damping = options.damping.value_or(align.damping);
  align.max_iterations = options.max_iterations;
  align.min_translation_step = options.min_step * lengths.extent;
  align.min_rotation_step = options.min_step;
  align.correlation_length = options.covariance ? kCorrelationPerRadius * lengths.radius : 0.0;
  align.num_threads = options.num_threads;
  align.stop = options.stop;
  return align;
}

AlignOptions known_pairs_options(const Lengths& lengths, const RegistrationOptions& options) {
  AlignOptions align = align_options(lengths, /*projective=*/false, options);
  if (!has_both_sides(options)) return align;
  // No search takes the neighbours of a point on a crease for the point itself: Table 2 is right for edges.
  align.information.edge.position = augmented_information().edge.position;
  align.kernel_chi2 = options.kernel_chi2;
  align.kernel_quantile = kKnownPairsQuantile;
  align.min_kernel_chi2 = kernel_at(kMinKernelPerRadiusOfKnownPairs * lengths.radius, align);
  align.kernel_direction_per_median = std::numeric_limits<double>::infinity();  // the median direction is false
  return align;
}

}  // namespace augicp
