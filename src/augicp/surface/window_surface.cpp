// SPDX-License-Identifier: MIT
#include "augicp/surface/window_surface.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/parallel.h"
#include "augicp/core/vectorized.h"
#include "augicp/surface/window_sums.h"

namespace augicp {
namespace {

// Covariance of the points in each window, and how many they are; zero where there are none.
AUGICP_VECTORIZED void covariances(const SumBatch<PointMoments>& sums, SymmetricBatch& m) {
  const auto& s = sums.channel;
  for (int k = 0; k < kBatch; ++k) {
    const double inverse = s[0][k] > 0.0 ? 1.0 / s[0][k] : 0.0;
    const double x = s[1][k] * inverse, y = s[2][k] * inverse, z = s[3][k] * inverse;
    m.xx[k] = static_cast<float>(s[4][k] * inverse - x * x);
    m.xy[k] = static_cast<float>(s[5][k] * inverse - x * y);
    m.xz[k] = static_cast<float>(s[6][k] * inverse - x * z);
    m.yy[k] = static_cast<float>(s[7][k] * inverse - y * y);
    m.yz[k] = static_cast<float>(s[8][k] * inverse - y * z);
    m.zz[k] = static_cast<float>(s[9][k] * inverse - z * z);
  }
}

// Mean outer product of the directions in each window, zero where there are none.
AUGICP_VECTORIZED void mean_outer_products(const SumBatch<DirectionMoments>& sums, SymmetricBatch& m) {
  const auto& s = sums.channel;
  for (int k = 0; k < kBatch; ++k) {
    const float inverse = s[0][k] > 0.0f ? 1.0f / s[0][k] : 0.0f;
    m.xx[k] = s[1][k] * inverse;
    m.xy[k] = s[2][k] * inverse;
    m.xz[k] = s[3][k] * inverse;
    m.yy[k] = s[4][k] * inverse;
    m.yz[k] = s[5][k] * inverse;
    m.zz[k] = s[6][k] * inverse;
  }
}

// An upper bound of l1 + l0 for matrices whose eigenvalues sum to 1 (or to 0), without finding them: l2 is at least the
// sum of their squares.
AUGICP_VECTORIZED float largest_spread(const SymmetricBatch& m) {
  BatchArray bound;
  for (int k = 0; k < kBatch; ++k)
    bound[k] = m.xx[k] + m.yy[k] + m.zz[k] -
               (m.xx[k] * m.xx[k] + m.yy[k] * m.yy[k] + m.zz[k] * m.zz[k] +
                2.0f * (m.xy[k] * m.xy[k] + m.xz[k] * m.xz[k] + m.yz[k] * m.yz[k]));
  float largest = 0.0f;
  for (int k = 0; k < kBatch; ++k) largest = bound[k] > largest ? bound[k] : largest;
  return largest;
}

void write_direction(float weight, const float* d, float* channels) {
  const float x = weight * d[0], y = weight * d[1], z = weight * d[2];
  channels[0] = weight;
  channels[1] = x * d[0];
  channels[2] = x * d[1];
  channels[3] = x * d[2];
  channels[4] = y * d[1];
  channels[5] = y * d[2];
  channels[6] = z * d[2];
  channels[7] = 0.0f;
}

// A unit vector and what it is worth, or what it is, one entry a pixel.
struct Direction {
  float xyz[3];
  float weight;  // 0: none
};

Direction direction_of(const VectorBatch& vectors, int k, float weight) {
  return {{vectors.x[k], vectors.y[k], vectors.z[k]}, weight};
}
bool is_zero(const Direction& d) { return d.xyz[0] == 0.0f && d.xyz[1] == 0.0f && d.xyz[2] == 0.0f; }

class WindowSurface {
 public:
  WindowSurface(const Cloud& cloud, const IndexImage& index, const WindowOptions& window, const SurfaceOptions& options,
                int num_threads)
      : cloud_(cloud),
        index_(index),
        options_(options),
        num_threads_(num_threads),
        width_(static_cast<std::size_t>(index.width)),
        spans_(window_spans(cloud, index, window, num_threads)),
        directions_(std::make_unique_for_overwrite<Direction[]>(index.index.size())),
        structures_(std::make_unique_for_overwrite<Structure[]>(index.index.size())) {}

  void find_shapes();
  void find_creases();
  void store(Cloud& cloud) const;

 private:
  bool write_points(std::size_t v, double* channels) const;
  void shapes_of(std::size_t v, std::size_t u, int count, const SumBatch<PointMoments>& sums);
  Structure structure_of(double count, float l0, float l1, float l2, bool is_along_sight) const;
  bool is_along_sight(std::size_t pixel, const Direction& line) const;
  bool write_normals(std::size_t v, float* channels) const;
  void spreads_of(std::size_t v, std::size_t u, int count, const SumBatch<DirectionMoments>& sums);
  bool write_tangents(std::size_t v, float* channels) const;
  bool may_be_creases(std::size_t v, std::size_t u, int count) const;
  void creases_of(std::size_t v, std::size_t u, int count, const SumBatch<DirectionMoments>& sums);

  const Cloud& cloud_;
  const IndexImage& index_;
  const SurfaceOptions& options_;
  int num_threads_;
  std::size_t width_;
  WindowSpans spans_;
  std::unique_ptr<Direction[]> directions_;  // weight 1 for normals, which alone are summed, else 0
  std::unique_ptr<Structure[]> structures_;
  std::unique_ptr<Direction[]> spreads_;  // NormalSpread's tangent with its across for a weight, 0 in corners
};

bool WindowSurface::write_points(std::size_t v, double* channels) const {
  bool any = false;
  for (std::size_t u = 0; u < width_; ++u, channels += PointMoments::kChannels) {
    const std::int32_t i = index_.index[v * width_ + u];
    if (i == IndexImage::kNone) {
      std::fill_n(channels, PointMoments::kChannels, 0.0);
      continue;
    }
    any = true;
    const Vec3d p = cloud_.points[i].cast<double>();
    channels[0] = 1.0;
    channels[1] = p.x(), channels[2] = p.y(), channels[3] = p.z();
    channels[4] = p.x() * p.x(), channels[5] = p.x() * p.y(), channels[6] = p.x() * p.z();
    channels[7] = p.y() * p.y(), channels[8] = p.y() * p.z(), channels[9] = p.z() * p.z();
  }
  return any;
}

bool WindowSurface::is_along_sight(std::size_t pixel, const Direction& line) const {
  const std::int32_t i = index_.index[pixel];
  if (!cloud_.viewpoint || i == IndexImage::kNone) return false;
  const Vec3d sight = (cloud_.points[i] - *cloud_.viewpoint).cast<double>().stableNormalized();
  return is_along(Vec3f(line.xyz).cast<double>(), sight, options_.thresholds);
}

Structure WindowSurface::structure_of(double count, float l0, float l1, float l2, bool along_sight) const {
  const ShapeThresholds& thresholds = options_.thresholds;
  if (count < thresholds.min_points || !(l2 > 0.0f)) return Structure::None;
  if (options_.classifier == Classifier::Eigenvalues) return structure_of_points(l0, l1, l2, thresholds);
  if (is_line(l1, l2, thresholds) && !along_sight) return Structure::Edge;
  return is_thick(l0, l1, thresholds) ? Structure::None : Structure::Planar;
}

void WindowSurface::shapes_of(std::size_t v, std::size_t u, int count, const SumBatch<PointMoments>& sums) {
  SymmetricBatch covariance;
  EigenvalueBatch values;
  VectorBatch normals, lines;
  covariances(sums, covariance);
  eigenvalues(covariance, values);
  eigenvectors(covariance, values.l0, normals);
  bool has_lines = false;
  for (int k = 0; k < count; ++k) {
    const std::size_t pixel = v * width_ + u + k;
    const double points = sums.channel[0][k];
    const float l0 = values.l0[k], l1 = values.l1[k], l2 = values.l2[k];
    Structure structure = structure_of(points, l0, l1, l2, false);
    Direction direction = direction_of(normals, k, 1.0f);
    if (structure == Structure::Edge) {
      if (!has_lines) eigenvectors(covariance, values.l2, lines);
      has_lines = true;
      const Direction line = direction_of(lines, k, 0.0f);
      structure = structure_of(points, l0, l1, l2, is_along_sight(pixel, line));
      if (structure == Structure::Edge) direction = line;
    }
    if (is_zero(direction)) structure = Structure::None;
    if (structure == Structure::None) direction = {};
    directions_[pixel] = direction;
    structures_[pixel] = structure;
  }
}

void WindowSurface::find_shapes() {
  auto in_rows = sums_over_rows<PointMoments>(
      spans_, num_threads_, [&](std::size_t v, double* channels) { return write_points(v, channels); });
  sum_over_columns<PointMoments>(
      spans_, std::move(in_rows), num_threads_, [](std::size_t, std::size_t, int) { return true; },
      [&](std::size_t v, std::size_t u, int count, const auto& sums) { shapes_of(v, u, count, sums); });
}

// Only normals count, see estimate_surface.cpp.
bool WindowSurface::write_normals(std::size_t v, float* channels) const {
  const Direction* const row = &directions_[v * width_];
  for (std::size_t u = 0; u < width_; ++u)
    write_direction(row[u].weight, row[u].xyz, channels + u * DirectionMoments::kChannels);
  return true;
}

void WindowSurface::spreads_of(std::size_t v, std::size_t u, int count, const SumBatch<DirectionMoments>& sums) {
  const ShapeThresholds& thresholds = options_.thresholds;
  const auto least = static_cast<float>(std::min(thresholds.min_crease, thresholds.clear_crease));
  Direction* const spreads = &spreads_[v * width_ + u];
  std::fill_n(spreads, count, Direction{});
  SymmetricBatch outer;
  mean_outer_products(sums, outer);
  if (largest_spread(outer) < least) return;
  EigenvalueBatch values;
  VectorBatch tangents;
  eigenvalues(outer, values);
  eigenvectors(outer, values.l0, tangents);
  for (int k = 0; k < count; ++k) {
    Structure& structure = structures_[v * width_ + u + k];
    const float across = values.l1[k], along = values.l0[k];
    if (across < least || structure == Structure::Edge) continue;
    if (sums.channel[0][k] < static_cast<float>(thresholds.min_points)) continue;
    if (along <= static_cast<float>(thresholds.max_corner))
      spreads[k] = direction_of(tangents, k, across);
    else if (across >= static_cast<float>(thresholds.min_crease))
      structure = Structure::None;
  }
}

// Only clear creases count, the middle of one more than its sides.
bool WindowSurface::write_tangents(std::size_t v, float* channels) const {
  const auto clear = static_cast<float>(options_.thresholds.clear_crease);
  const Direction* const row = &spreads_[v * width_];
  bool any = false;
  for (std::size_t u = 0; u < width_; ++u) {
    const bool is_clear = row[u].weight >= clear;
    any = any || is_clear;
    write_direction(is_clear ? row[u].weight : 0.0f, row[u].xyz, channels + u * DirectionMoments::kChannels);
  }
  return any;
}

bool WindowSurface::may_be_creases(std::size_t v, std::size_t u, int count) const {
  const auto least = static_cast<float>(options_.thresholds.min_crease);
  const Direction* const spreads = &spreads_[v * width_ + u];
  return std::any_of(spreads, spreads + count, [&](const Direction& spread) { return spread.weight >= least; });
}

void WindowSurface::creases_of(std::size_t v, std::size_t u, int count, const SumBatch<DirectionMoments>& sums) {
  const auto least = static_cast<float>(options_.thresholds.min_crease),
             clear = static_cast<float>(options_.thresholds.clear_crease);
  SymmetricBatch outer;
  EigenvalueBatch values;
  VectorBatch tangents;
  mean_outer_products(sums, outer);
  eigenvalues(outer, values);
  eigenvectors(outer, values.l2, tangents);
  for (int k = 0; k < count; ++k) {
    const std::size_t pixel = v * width_ + u + k;
    if (spreads_[pixel].weight < least || sums.channel[0][k] < clear) continue;
    directions_[pixel] = direction_of(tangents, k, 0.0f);
    structures_[pixel] = is_zero(directions_[pixel]) ? Structure::None : Structure::Edge;
  }
}

void WindowSurface::find_creases() {
  spreads_ = std::make_unique_for_overwrite<Direction[]>(index_.index.size());
  const auto everywhere = [](std::size_t, std::size_t, int) { return true; };
  auto in_rows = sums_over_rows<DirectionMoments>(
      spans_, num_threads_, [&](std::size_t v, float* channels) { return write_normals(v, channels); });
  sum_over_columns<DirectionMoments>(
      spans_, std::move(in_rows), num_threads_, everywhere,
      [&](std::size_t v, std::size_t u, int count, const auto& sums) { spreads_of(v, u, count, sums); });
  auto tangents_in_rows = sums_over_rows<DirectionMoments>(
      spans_, num_threads_, [&](std::size_t v, float* channels) { return write_tangents(v, channels); });
  sum_over_columns<DirectionMoments>(
      spans_, std::move(tangents_in_rows), num_threads_,
      [&](std::size_t v, std::size_t u, int count) { return may_be_creases(v, u, count); },
      [&](std::size_t v, std::size_t u, int count, const auto& sums) { creases_of(v, u, count, sums); });
}

void WindowSurface::store(Cloud& cloud) const {
  cloud.directions.assign(cloud.size(), Vec3f::Zero());  // so they stay where a point has no pixel or no structure
  cloud.structures.assign(cloud.size(), Structure::None);
  const auto store_pixels = [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      const std::int32_t i = index_.index[pixel];
      const Structure structure = structures_[pixel];
      if (i == IndexImage::kNone || structure == Structure::None) continue;
      Vec3f direction(directions_[pixel].xyz);
      if (structure == Structure::Planar && cloud.viewpoint) point_towards(*cloud.viewpoint, cloud.points[i], direction);
      cloud.structures[i] = structure;
      cloud.directions[i] = direction;
    }
  };
  for_each_block(index_.index.size(), num_threads_, store_pixels, kLightBlockSize);
}

}  // namespace

void estimate_surface(Cloud& cloud, const IndexImage& index, const WindowOptions& window, const SurfaceOptions& options,
                      int num_threads) {
  WindowSurface surface(cloud, index, window, options, num_threads);
  surface.find_shapes();
  if (options.classifier == Classifier::Normals) surface.find_creases();
  surface.store(cloud);
}

}  // namespace augicp
