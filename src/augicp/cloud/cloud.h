// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// What the surface is like around a point (section 3.1). It says what the point's direction means.
enum class Structure : std::uint8_t {
  None,    // a corner, or unknown: no direction
  Planar,  // direction is the surface normal
  Edge,    // direction is the tangent of a crease or of a thin thing; a tangent and its opposite are the same edge
};

// A cloud of extended points. Arrays are packed (N,3) and index i means the same point in each of them.
//
// Points are kept relative to `origin`, so that float is fine enough for clouds far from zero (UTM coordinates):
// x_in_frame = origin + point. Every point is finite. Const access may be concurrent.
struct Cloud {
  std::vector<Vec3f> points;          // metres, relative to origin
  std::vector<Vec3f> directions;      // empty, or one a point: unit length, zero where the structure is None
  std::vector<Structure> structures;  // as many as directions
  Vec3d origin = Vec3d::Zero();       // metres

  // How much each point's measurement counts beside the best ones': the inverse of its variance, in (0, 1]. Empty: all
  // alike.
  std::vector<float> weights;

  // How bright each point is, in any unit: a camera's grey value, a LiDAR's return. NaN where that is not known. Empty:
  // none is.
  std::vector<float> intensities;

  // How the intensity changes along the surface, per metre; zero where that is not known, and empty until it is
  // estimated, see surface/intensity_gradient.h.
  std::vector<Vec3f> intensity_gradients;

  // Where the sensor was, relative to origin as the points are. Where it is known, normals point to it; where it is
  // not, a normal and its opposite are the same plane.
  std::optional<Vec3f> viewpoint;

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }
  bool has_directions() const { return !points.empty() && directions.size() == points.size(); }
  bool has_intensities() const { return !points.empty() && intensities.size() == points.size(); }
  bool has_intensity_gradients() const { return has_intensities() && intensity_gradients.size() == points.size(); }
};

// Whether normals of the two clouds compare with their sign: where both sensors' places are known.
inline bool normals_have_signs(const Cloud& source, const Cloud& target) {
  return source.viewpoint && target.viewpoint;
}

// The frame moved: points, origin, viewpoint, directions and gradients, Eq. (4) and (7).
Cloud transform(const Cloud& cloud_in_a, const Rigid3& b_from_a);

// Axis-aligned bounds relative to origin, metres. Both zero for an empty cloud.
struct Bounds {
  Vec3f min = Vec3f::Zero();
  Vec3f max = Vec3f::Zero();
  double diagonal() const { return static_cast<double>((max - min).norm()); }
};
Bounds bounds(const Cloud& cloud);

// The pose between the frames of two clouds, given the pose between their points (both without their origins), and
// back.
Rigid3 with_origins(const Rigid3& target_points_from_source_points, const Cloud& source, const Cloud& target);
Rigid3 without_origins(const Rigid3& target_from_source, const Cloud& source, const Cloud& target);

}  // namespace augicp
