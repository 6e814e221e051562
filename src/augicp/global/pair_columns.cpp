// SPDX-License-Identifier: MIT
#include "augicp/global/pair_columns.h"

#include "augicp/core/vectorized.h"

namespace augicp {
namespace {

constexpr std::size_t kPadding = 16;

std::array<std::vector<float>, 6> columns_of(const KeyPoints& keys, std::span<const Correspondence> pairs,
                                             std::uint32_t Correspondence::*side, std::size_t padded) {
  std::array<std::vector<float>, 6> columns;
  for (auto& column : columns) column.resize(padded);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      columns[static_cast<std::size_t>(k)][i] = keys.points[pairs[i].*side][k];
      columns[static_cast<std::size_t>(k) + 3][i] = keys.normals[pairs[i].*side][k];
    }
  return columns;
}

struct View {
  const float *x, *y, *z, *nx, *ny, *nz;
  explicit View(const std::array<std::vector<float>, 6>& of)
      : x(of[0].data()), y(of[1].data()), z(of[2].data()), nx(of[3].data()), ny(of[4].data()), nz(of[5].data()) {}
};

// Rows of the rotation, and the translation.
struct Pose {
  float xx, xy, xz, yx, yy, yz, zx, zy, zz, x, y, z;
  explicit Pose(const Rigid3f& of)
      : xx(of.rotation(0, 0)),
        xy(of.rotation(0, 1)),
        xz(of.rotation(0, 2)),
        yx(of.rotation(1, 0)),
        yy(of.rotation(1, 1)),
        yz(of.rotation(1, 2)),
        zx(of.rotation(2, 0)),
        zy(of.rotation(2, 1)),
        zz(of.rotation(2, 2)),
        x(of.translation.x()),
        y(of.translation.y()),
        z(of.translation.z()) {}
};

struct Limits {
  float distance_sq, cosine;
};

// Numbers are combined without a branch.
AUGICP_INLINE std::int32_t number(bool is_true) { return is_true ? 1 : 0; }

// As Eigen adds them up.
AUGICP_INLINE float dot(float ax, float ay, float az, float bx, float by, float bz) {
  return ax * bx + (ay * by + az * bz);
}

AUGICP_VECTORIZED
void mark_supporting(const View& source, const View& target, const Pose& pose, const Limits& limits, std::size_t count,
                     std::int32_t* supports) {
  for (std::size_t k = 0; k < count; ++k) {
    const float x = source.x[k], y = source.y[k], z = source.z[k];
    const float dx = dot(pose.xx, pose.xy, pose.xz, x, y, z) + pose.x - target.x[k];
    const float dy = dot(pose.yx, pose.yy, pose.yz, x, y, z) + pose.y - target.y[k];
    const float dz = dot(pose.zx, pose.zy, pose.zz, x, y, z) + pose.z - target.z[k];
    const float nx = source.nx[k], ny = source.ny[k], nz = source.nz[k];
    const float cosine = dot(dot(pose.xx, pose.xy, pose.xz, nx, ny, nz), dot(pose.yx, pose.yy, pose.yz, nx, ny, nz),
                             dot(pose.zx, pose.zy, pose.zz, nx, ny, nz), target.nx[k], target.ny[k], target.nz[k]);
    supports[k] = number(dot(dx, dy, dz, dx, dy, dz) <= limits.distance_sq) & number(cosine >= limits.cosine);
  }
}

}  // namespace

PairColumns::PairColumns(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs)
    : size_(pairs.size()) {
  const std::size_t padded = (size_ + kPadding - 1) / kPadding * kPadding;
  source_ = columns_of(source, pairs, &Correspondence::source, padded);
  target_ = columns_of(target, pairs, &Correspondence::target, padded);
}

std::vector<std::uint32_t> PairColumns::supporting(const Rigid3& target_from_source, double distance,
                                                   double cosine) const {
  std::vector<std::int32_t> supports(source_[0].size());
  const Limits limits{static_cast<float>(distance * distance), static_cast<float>(cosine)};
  mark_supporting(View(source_), View(target_), Pose(Rigid3f(target_from_source)), limits, supports.size(),
                  supports.data());
  std::vector<std::uint32_t> found;
  for (std::uint32_t k = 0; k < size_; ++k)
    if (supports[k] != 0) found.push_back(k);
  return found;
}

}  // namespace augicp
