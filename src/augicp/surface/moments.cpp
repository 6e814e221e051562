// SPDX-License-Identifier: MIT
#include "augicp/surface/moments.h"

namespace augicp {

void pack(const Mat3d& m, Eigen::Ref<Eigen::Array<double, 6, 1>> packed) {
  packed << m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2);
}

Mat3d unpack(const Eigen::Ref<const Eigen::Array<double, 6, 1>>& packed) {
  const auto& p = packed;
  Mat3d m;
  m << p[0], p[1], p[2], p[1], p[3], p[4], p[2], p[4], p[5];
  return m;
}

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

}  // namespace augicp
