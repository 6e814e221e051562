// SPDX-License-Identifier: MIT
#include "augicp/surface/estimate_surface.h"

#include "augicp/core/parallel.h"

namespace augicp {
namespace {

// Upper triangle of a symmetric matrix as six numbers, and back.
void pack(const Mat3d& m, Eigen::Ref<Eigen::Array<double, 6, 1>> packed) {
  packed << m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2);
}
Mat3d unpack(const Eigen::Ref<const Eigen::Array<double, 6, 1>>& p) {
  Mat3d m;
  m << p[0], p[1], p[2], p[1], p[3], p[4], p[2], p[4], p[5];
  return m;
}

// Count, sum and sum of outer products: what Eq. (15) needs.
Channels point_moments(const Cloud& cloud) {
  Channels moments(10, static_cast<Eigen::Index>(cloud.size()));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3d p = cloud.points[i].cast<double>();
    auto column = moments.col(static_cast<Eigen::Index>(i));
    column[0] = 1.0;
    column.segment<3>(1) = p;
    pack(p * p.transpose(), column.segment<6>(4));
  }
  return moments;
}

Gaussian gaussian_of(const Eigen::Ref<const Eigen::ArrayXd>& moments) {
  Gaussian gaussian;
  gaussian.count = moments[0];
  gaussian.mean = moments.segment<3>(1) / moments[0];
  gaussian.covariance = unpack(moments.segment<6>(4)) / moments[0] - gaussian.mean * gaussian.mean.transpose();
  return gaussian;
}

// Only normals count: a wire beside a wall must not turn the wall into an edge.
Channels normal_moments(const std::vector<Shape>& shapes) {
  Channels moments = Channels::Zero(7, static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].direction.isZero()) continue;
    auto column = moments.col(static_cast<Eigen::Index>(i));
    column[0] = 1.0;
    pack(shapes[i].direction * shapes[i].direction.transpose(), column.segment<6>(1));
  }
  return moments;
}

void towards(const Vec3f& viewpoint, const Vec3f& point, Vec3f& normal) {
  if (normal.dot(viewpoint - point) < 0.0f) normal = -normal;
}

void store(const std::vector<Shape>& shapes, Cloud& cloud) {
  cloud.directions.resize(cloud.size());
  cloud.structures.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.structures[i] = shapes[i].structure;
    cloud.directions[i] = shapes[i].direction.cast<float>();
    if (shapes[i].structure == Structure::Planar && cloud.viewpoint)
      towards(*cloud.viewpoint, cloud.points[i], cloud.directions[i]);
  }
}

}  // namespace

void estimate_surface(Cloud& cloud, const Neighbourhood& neighbourhood, const SurfaceOptions& options, int num_threads) {
  const ShapeThresholds& thresholds = options.thresholds;
  const bool by_normals = options.classifier == Classifier::Normals;
  std::vector<Shape> shapes(cloud.size());
  std::vector<Shape> normals(cloud.size());
  const Channels sums = neighbourhood.sum(point_moments(cloud), num_threads);
  for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Gaussian points = gaussian_of(sums.col(static_cast<Eigen::Index>(i)));
      const Eigen3 eigen = eigen_of_symmetric(points.covariance);
      shapes[i] = shape_of_points(points, eigen, thresholds);
      if (points.count >= thresholds.min_points && eigen.values[1] >= thresholds.max_line_ratio * eigen.values[2])
        normals[i] = {Structure::Planar, eigen.vectors.col(0)};
    }
  });
  if (by_normals) {
    const Channels around = neighbourhood.sum(normal_moments(normals), num_threads);
    for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto column = around.col(static_cast<Eigen::Index>(i));
        if (normals[i].structure == Structure::None || column[0] < thresholds.min_points) continue;
        shapes[i] = shape_of_normals(normals[i], unpack(column.segment<6>(1)) / column[0], thresholds);
      }
    });
  }
  store(shapes, cloud);
}

}  // namespace augicp
