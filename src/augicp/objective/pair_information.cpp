// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_information.h"

#include <algorithm>

#include "augicp/core/vectorized.h"
#include "augicp/objective/pair_vectors.h"

namespace augicp {
namespace {

constexpr auto kNone = static_cast<std::int32_t>(Structure::None);

// across I + (along - across) d d^T.
inline Symmetric about(float along, float across, const Vecf& d) {
  const Vecf s = scaled(along - across, d);
  return {across + s.x * d.x, s.x * d.y, s.x * d.z, across + s.y * d.y, s.y * d.z, across + s.z * d.z};
}

// A covariance across I + (along - across) d d^T about a direction d, which is a unit vector or zero.
struct Variances {
  float along, across;
};

// (C + C')^-1 of covariances about d and m. With u = across + across', and v = along - across of each:
// C + C' = u I + v d d^T + v' m m^T, which Woodbury's identity inverts through a 2x2 matrix. Of the two forms of its
// determinant, (u + v) (u + v') - v v' (d.m)^2 = u (u + v + v') + v v' |d x m|^2, one has no difference: no digits
// cancel where planes agree, nor where an edge lies in a plane.
inline Symmetric inverse_of_sum(const Variances& target, const Variances& source, const Vecf& d, const Vecf& m) {
  const float u = target.across + source.across;
  const float v = target.along - target.across, w = source.along - source.across;
  const float cosine = dot(d, m), vw = v * w;
  const Vecf normal = cross(d, m);
  const float determinant =
      vw > 0.0f ? u * (target.along + source.along) + vw * dot(normal, normal)
                : (target.along + source.across) * (target.across + source.along) - vw * cosine * cosine;
  const float scale = 1.0f / (u * determinant), i = 1.0f / u;
  const float dd = scale * v * (u + w), mm = scale * w * (u + v), dm = scale * vw * cosine;
  const Vecf p = difference(scaled(dd, d), scaled(dm, m)), q = difference(scaled(mm, m), scaled(dm, d));
  return {i - (p.x * d.x + q.x * m.x), -(p.x * d.y + q.x * m.y), -(p.x * d.z + q.x * m.z),
          i - (p.y * d.y + q.y * m.y), -(p.y * d.z + q.y * m.z), i - (p.z * d.z + q.z * m.z)};
}

// How many times a variance is the best points'. Entries behind the last pair have no weight, and count for nothing.
inline float noise_of(float weight) { return weight > 0.0f ? 1.0f / weight : 1.0f; }

AUGICP_VECTORIZED void weigh_by_target(const InformationTable& __restrict table, const float* __restrict counts,
                                       const PairBatch& __restrict b, PairBatch::Symmetric& __restrict information) {
  const ByStructure along = table.along, across = table.across;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const std::int32_t structure = b.structure[k];
    const float weight = counts[k] * b.weight[k];
    put(information, k, about(weight * along.of(structure), weight * across.of(structure), at(b.target_direction, k)));
  }
}

AUGICP_VECTORIZED void weigh_by_both(const InformationTable& __restrict table, const float* __restrict counts,
                                     const PairBatch& __restrict b, PairBatch::Symmetric& __restrict information) {
  const ByStructure along = table.along, across = table.across;
  const float scale = table.scale;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const std::int32_t i = b.structure[k], j = b.source_structure[k];
    const float noise_i = noise_of(b.weight[k]), noise_j = noise_of(b.source_weight[k]);
    const Variances target{noise_i * along.of(i), noise_i * across.of(i)};
    const Variances source{noise_j * along.of(j), noise_j * across.of(j)};
    const Symmetric inverse = inverse_of_sum(target, source, at(b.target_direction, k), at(b.moved_direction, k));
    put(information, k, scaled(b.weight[k] > 0.0f ? counts[k] * scale : 0.0f, inverse));
  }
}

void weigh(const InformationTable& table, const float* counts, const PairBatch& batch,
           PairBatch::Symmetric& information) {
  table.sides == Sides::Both ? weigh_by_both(table, counts, batch, information)
                             : weigh_by_target(table, counts, batch, information);
}

// Where the structures differ the linear error has no meaning: Omega^l = 0.
AUGICP_VECTORIZED void compare_structures(PairBatch& __restrict b) {
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const bool are_alike = (b.structure[k] != kNone) & (b.structure[k] == b.source_structure[k]);
    b.compares[k] = are_alike ? 1.0f : 0.0f;
  }
}

}  // namespace

InformationTable information_table(const InformationModel& model, Information StructureInformation::*part, Sides sides,
                                   double unit) {
  double best = 0.0;
  for (const StructureInformation* row : {&model.none, &model.planar, &model.edge})
    best = std::max({best, (row->*part).along, (row->*part).across});
  // A row without information, of pairs that are not compared, is given any variance that is one.
  const auto number = [&](double information) {
    const double found = sides != Sides::Both ? information / unit : information > 0.0 ? best / information : 1.0;
    return static_cast<float>(found);
  };
  const auto numbers = [&](double Information::*side) {
    const auto of = [&](const StructureInformation& row) { return number(row.*part.*side); };
    return ByStructure{of(model.none), of(model.planar), of(model.edge)};
  };
  return {numbers(&Information::along), numbers(&Information::across), static_cast<float>(best / unit), sides};
}

void weigh_positions(const InformationTable& table, PairBatch& batch) {
  alignas(64) float all[kPairsPerBatch];
  std::fill_n(all, kPairsPerBatch, 1.0f);
  weigh(table, all, batch, batch.position_information);
}

void weigh_by_gaussians(std::span<const PointGaussian> of_target, std::span<const Correspondence> pairs, float per_unit,
                        PairBatch& batch) {
  const Symmetric nothing{};
  for (int k = 0; k < kPairsPerBatch; ++k) {
    if (static_cast<std::size_t>(k) >= pairs.size()) {
      put(batch.position_information, k, nothing);
      continue;
    }
    const Eigen::Matrix3f& m = of_target[pairs[static_cast<std::size_t>(k)].target].information;
    const Symmetric information{m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
    put(batch.position_information, k, scaled(per_unit * batch.weight[k], information));
  }
}

void weigh_directions(const InformationTable& table, PairBatch& batch) {
  compare_structures(batch);
  weigh(table, batch.compares, batch, batch.direction_information);
}

}  // namespace augicp
