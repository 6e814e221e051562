// SPDX-License-Identifier: MIT
#include "augicp/global/pair_columns.h"

#include "augicp/core/vectorized.h"
#include "augicp/global/dot.h"
#include "augicp/global/packed_bits.h"

namespace augicp {
namespace {

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

struct PairView {
  const float *x, *y, *z, *nx, *ny, *nz;
  explicit PairView(const std::array<std::vector<float>, 6>& of)
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

struct SupportLimits {
  float distance_sq, cosine;
};

AUGICP_VECTORIZED
std::uint64_t supporting_bits(const PairView& source, const PairView& target, const Pose& pose,
                              const SupportLimits& limits, std::size_t begin) {
  alignas(64) std::int32_t supports[kBitsPerWord];
  for (std::size_t bit = 0; bit < kBitsPerWord; ++bit) {
    const std::size_t k = begin + bit;
    const float x = source.x[k], y = source.y[k], z = source.z[k];
    const float dx = dot(pose.xx, pose.xy, pose.xz, x, y, z) + pose.x - target.x[k];
    const float dy = dot(pose.yx, pose.yy, pose.yz, x, y, z) + pose.y - target.y[k];
    const float dz = dot(pose.zx, pose.zy, pose.zz, x, y, z) + pose.z - target.z[k];
    const float nx = source.nx[k], ny = source.ny[k], nz = source.nz[k];
    const float cosine = dot(dot(pose.xx, pose.xy, pose.xz, nx, ny, nz), dot(pose.yx, pose.yy, pose.yz, nx, ny, nz),
                             dot(pose.zx, pose.zy, pose.zz, nx, ny, nz), target.nx[k], target.ny[k], target.nz[k]);
    supports[bit] = number(dot(dx, dy, dz, dx, dy, dz) <= limits.distance_sq) & number(cosine >= limits.cosine);
  }
  return packed_bits(supports);
}

}  // namespace

PairColumns::PairColumns(const KeyPoints& source, const KeyPoints& target, std::span<const Correspondence> pairs)
    : size_(pairs.size()) {
  const std::size_t padded = (size_ + kBitsPerWord - 1) / kBitsPerWord * kBitsPerWord;
  source_ = columns_of(source, pairs, &Correspondence::source, padded);
  target_ = columns_of(target, pairs, &Correspondence::target, padded);
}

std::vector<std::uint32_t> PairColumns::supporting(const Rigid3& target_from_source, double distance,
                                                   double cosine) const {
  const SupportLimits limits{static_cast<float>(distance * distance), static_cast<float>(cosine)};
  const PairView from(source_), to(target_);
  const Pose pose{Rigid3f(target_from_source)};
  std::vector<std::uint32_t> found;
  for (std::size_t begin = 0; begin < size_; begin += kBitsPerWord)
    append_set_bits(supporting_bits(from, to, pose, limits, begin), begin / kBitsPerWord, found);
  // The padding may support it too.
  while (!found.empty() && found.back() >= size_) found.pop_back();
  return found;
}

}  // namespace augicp
