// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// The surface around a point (section 3.1). It defines the meaning of the point's direction.
enum class Structure : std::uint8_t {
  None,    // a corner, or unknown: no direction
  Planar,  // direction is the surface normal
  Edge,    // direction is the tangent of a crease or of a thin object; a tangent and its opposite are the same edge
};

// The Gaussian of the points around a point, which Eq. (2) weighs a pair by.
struct PointGaussian {
  Vec3f mean = Vec3f::Zero();  // metres, relative to the cloud's origin

  // The inverse covariance, symmetric, in a unit of the estimator's choice; see surface/gaussians.h. Zero: too few
  // points are near, and pairs with this point do not count.
  Eigen::Matrix3f information = Eigen::Matrix3f::Zero();
};

// The Gaussian of the moved points.
PointGaussian operator*(const Rigid3f& b_from_a, const PointGaussian& gaussian_in_a);

// A cloud of extended points. Arrays are packed (N,3), and index i means the same point in each of them.
//
// Points are relative to `origin`, so that float is precise enough for clouds far from zero (UTM coordinates):
// x_in_frame = origin + point. Invariant: every point is finite. Thread safety: const access may be concurrent.
struct Cloud {
  std::vector<Vec3f> points;          // metres, relative to origin
  std::vector<Vec3f> directions;      // empty, or one per point: unit length, zero if the structure is None
  std::vector<Structure> structures;  // the same size as directions
  Vec3d origin = Vec3d::Zero();       // metres

  // Weight of each point's measurement: the inverse of its variance, relative to the best point, in (0, 1]. Empty: all
  // points have the same weight.
  std::vector<float> weights;

  // Brightness of each point in any unit: a camera's grey value, or a LiDAR's return. NaN if unknown. Empty: all are
  // unknown.
  std::vector<float> intensities;

  // Gradient of the intensity along the surface, per metre; zero if unknown. Empty until it is estimated, see
  // surface/intensity_gradient.h.
  std::vector<Vec3f> intensity_gradients;

  // The Gaussian around each point. Empty until it is estimated, see surface/gaussians.h.
  std::vector<PointGaussian> gaussians;

  // Position of the sensor, relative to origin like the points. If it is known, normals point to it. If not, a normal
  // and its opposite are the same plane.
  std::optional<Vec3f> viewpoint;

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }
  bool has_directions() const { return !points.empty() && directions.size() == points.size(); }
  bool has_intensities() const { return !points.empty() && intensities.size() == points.size(); }
  bool has_intensity_gradients() const { return has_intensities() && intensity_gradients.size() == points.size(); }
  bool has_gaussians() const { return !points.empty() && gaussians.size() == points.size(); }
};

// Whether normals of the two clouds are compared with their sign: true if both sensor positions are known.
inline bool normals_have_signs(const Cloud& source, const Cloud& target) {
  return source.viewpoint && target.viewpoint;
}

// The cloud in another frame: points, origin, viewpoint, directions, gradients and Gaussians are moved, Eq. (4)
// and (7).
Cloud transform(const Cloud& cloud_in_a, const Rigid3& b_from_a);

// Axis-aligned bounds relative to origin, in metres. Both are zero for an empty cloud.
struct Bounds {
  Vec3f min = Vec3f::Zero();
  Vec3f max = Vec3f::Zero();
  double diagonal() const { return static_cast<double>((max - min).norm()); }
};
Bounds bounds(const Cloud& cloud);

// Converts the pose between the points of two clouds (both without their origins) to the pose between their frames, and
// back.
Rigid3 with_origins(const Rigid3& target_points_from_source_points, const Cloud& source, const Cloud& target);
Rigid3 without_origins(const Rigid3& target_from_source, const Cloud& source, const Cloud& target);

}  // namespace augicp
