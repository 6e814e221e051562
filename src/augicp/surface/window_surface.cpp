// SPDX-License-Identifier: MIT
#include "augicp/surface/window_surface.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "augicp/core/parallel.h"
#include "augicp/surface/window_passes.h"
#include "augicp/surface/window_shapes.h"

namespace augicp {
namespace {

// All per-pixel data in one allocation. When freed, glibc keeps it for the next image. Several allocations would go
// back to the system, which clears new pages: a third of the time of an image.
class PixelMemory {
 public:
  explicit PixelMemory(const IndexImage& image)
      : count_(image.index.size()),
        memory_(std::make_unique_for_overwrite<std::byte[]>(count_ * (2 * sizeof(Direction) + 2 * sizeof(Span) + 1))) {
    static_assert(sizeof(Structure) == 1);
  }
  Direction* directions() const { return reinterpret_cast<Direction*>(memory_.get()); }
  Direction* spreads() const { return directions() + count_; }
  std::span<Span> spans_in_row() const { return {reinterpret_cast<Span*>(spreads() + count_), count_}; }
  std::span<Span> spans_in_column() const { return {spans_in_row().data() + count_, count_}; }
  Structure* structures() const { return reinterpret_cast<Structure*>(spans_in_column().data() + count_); }

 private:
  std::size_t count_;
  std::unique_ptr<std::byte[]> memory_;
};

class WindowSurface {
 public:
  WindowSurface(const Cloud& cloud, const IndexImage& index, const WindowOptions& window, const SurfaceOptions& options,
                int num_threads)
      : cloud_(cloud),
        index_(index),
        options_(options),
        num_threads_(num_threads),
        width_(static_cast<std::size_t>(index.width)),
        height_(static_cast<std::size_t>(index.height)),
        pixels_(index),
        spans_{index.width, index.height, pixels_.spans_in_row(), pixels_.spans_in_column()},
        directions_(pixels_.directions()),
        spreads_(pixels_.spreads()),
        structures_(pixels_.structures()) {
    find_window_spans(cloud, index, window, num_threads, spans_);
  }

  void find_shapes();
  void find_creases();
  void store(Cloud& cloud) const;

 private:
  void shapes_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows);
  bool is_along_sight(std::size_t pixel, const Vec3f& line) const;
  void choose_lines(std::size_t first_pixel, int count, const WindowBatch& windows, const EigenvalueBatch& values,
                    StructureBatch& structures, VectorBatch& directions) const;
  void spreads_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows);
  void creases_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows);
  std::uint8_t& may_be_creases(std::size_t v, std::size_t u) { return may_be_creases_[u / kBatch * height_ + v]; }

  const Cloud& cloud_;
  const IndexImage& index_;
  const SurfaceOptions& options_;
  int num_threads_;
  std::size_t width_, height_;
  PixelMemory pixels_;
  WindowSpans spans_;
  Direction* directions_;  // weight 1 for normals (only these are summed), else 0
  Direction* spreads_;     // NormalSpread's tangent, weighted by its across; 0 in corners
  Structure* structures_;
  std::vector<std::uint8_t> may_be_creases_;  // whether any spread of a batch is wide enough
};

bool WindowSurface::is_along_sight(std::size_t pixel, const Vec3f& line) const {
  const std::int32_t i = index_.index[pixel];
  if (!cloud_.viewpoint || i == IndexImage::kNone) return false;
  const Vec3d sight = (cloud_.points[i] - *cloud_.viewpoint).cast<double>().stableNormalized();
  return is_along(line.cast<double>(), sight, options_.thresholds);
}

// Gives edges their direction, except lines along the line of sight, which become planar or lose their structure.
void WindowSurface::choose_lines(std::size_t first_pixel, int count, const WindowBatch& windows,
                                 const EigenvalueBatch& values, StructureBatch& structures,
                                 VectorBatch& directions) const {
  VectorBatch lines;
  eigenvectors(windows.matrix, values.l2, lines);
  for (int k = 0; k < count; ++k) {
    if (structures[k] != static_cast<std::int32_t>(Structure::Edge)) continue;
    const Vec3f line(lines.x[k], lines.y[k], lines.z[k]);
    if (options_.classifier == Classifier::Normals && is_along_sight(first_pixel + k, line)) {
      const bool thick = is_thick(values.l0[k], values.l1[k], options_.thresholds);
      structures[k] = static_cast<std::int32_t>(thick ? Structure::None : Structure::Planar);
    } else {
      directions.x[k] = line.x(), directions.y[k] = line.y(), directions.z[k] = line.z();
    }
  }
}

void WindowSurface::shapes_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows) {
  const std::size_t pixel = v * width_ + u;
  fetch_rows_ahead(directions_, width_, height_, v, u, count);
  EigenvalueBatch values;
  VectorBatch directions;
  StructureBatch structures;
  eigenvalues(windows.matrix, values);
  eigenvectors(windows.matrix, values.l0, directions);
  if (structures_of_points(windows, values, options_, structures))
    choose_lines(pixel, count, windows, values, structures, directions);
  write_shapes(structures, directions, count, &directions_[pixel], &structures_[pixel]);
}

void WindowSurface::find_shapes() {
  for_each_window<PointMoments>(
      spans_, num_threads_,
      [&](std::size_t v, Span part, double* prefix) {
        accumulate(cloud_.points.data(), &index_.index[v * width_ + part.begin], part.end - part.begin, prefix);
      },
      [](std::size_t, std::size_t) { return true; },
      [&](std::size_t v, std::size_t u, int count, const WindowBatch& windows) { shapes_of(v, u, count, windows); });
}

void WindowSurface::spreads_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows) {
  const std::size_t pixel = v * width_ + u;
  fetch_rows_ahead(spreads_, width_, height_, v, u, count);
  may_be_creases(v, u) = may_spread(windows, options_.thresholds);
  if (!may_be_creases(v, u)) {
    std::fill_n(&spreads_[pixel], count, Direction{});
    return;
  }
  EigenvalueBatch values;
  VectorBatch tangents;
  eigenvalues(windows.matrix, values);
  eigenvectors(windows.matrix, values.l0, tangents);
  may_be_creases(v, u) =
      write_spreads(windows, values, tangents, options_.thresholds, count, &spreads_[pixel], &structures_[pixel]);
}

void WindowSurface::creases_of(std::size_t v, std::size_t u, int count, const WindowBatch& windows) {
  const auto least = static_cast<float>(options_.thresholds.min_crease),
             clear = static_cast<float>(options_.thresholds.clear_crease);
  EigenvalueBatch values;
  VectorBatch tangents;
  eigenvalues(windows.matrix, values);
  eigenvectors(windows.matrix, values.l2, tangents);
  for (int k = 0; k < count; ++k) {
    const std::size_t pixel = v * width_ + u + k;
    if (spreads_[pixel].weight < least || windows.weight[k] < clear) continue;
    const Vec3f tangent(tangents.x[k], tangents.y[k], tangents.z[k]);
    directions_[pixel] = {{tangent.x(), tangent.y(), tangent.z()}, 0.0f};
    structures_[pixel] = tangent.isZero(0.0f) ? Structure::None : Structure::Edge;
  }
}

// Only normals count; of tangents only those of clear creases, with larger weights in the middle than at the sides: see
// estimate_surface.cpp.
void WindowSurface::find_creases() {
  may_be_creases_.resize((width_ + kBatch - 1) / kBatch * height_);
  const auto sums_of = [&](const Direction* directions, float least_weight) {
    return [=, this](std::size_t v, Span part, float* prefix) {
      accumulate(&directions[v * width_ + part.begin], part.end - part.begin, least_weight, prefix);
    };
  };
  for_each_window<DirectionMoments>(
      spans_, num_threads_, sums_of(directions_, 0.0f), [](std::size_t, std::size_t) { return true; },
      [&](std::size_t v, std::size_t u, int count, const WindowBatch& windows) { spreads_of(v, u, count, windows); });
  for_each_window<DirectionMoments>(
      spans_, num_threads_, sums_of(spreads_, static_cast<float>(options_.thresholds.clear_crease)),
      [&](std::size_t v, std::size_t u) { return may_be_creases(v, u) != 0; },
      [&](std::size_t v, std::size_t u, int count, const WindowBatch& windows) { creases_of(v, u, count, windows); });
}

void WindowSurface::store(Cloud& cloud) const {
  cloud.directions.assign(cloud.size(), Vec3f::Zero());  // for points without a pixel or a structure
  cloud.structures.assign(cloud.size(), Structure::None);
  const auto store_pixels = [&](std::size_t begin, std::size_t end) {
    for (std::size_t pixel = begin; pixel < end; ++pixel) {
      const std::int32_t i = index_.index[pixel];
      const Structure structure = structures_[pixel];
      if (i == IndexImage::kNone || structure == Structure::None) continue;
      Vec3f direction(directions_[pixel].xyz);
      if (structure == Structure::Planar && cloud.viewpoint)
        point_towards(*cloud.viewpoint, cloud.points[i], direction);
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
