// SPDX-License-Identifier: MIT
#include "augicp/match/pair_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "augicp/core/check.h"
#include "augicp/core/vectorized.h"
#include "augicp/match/agreement.h"

namespace augicp {
namespace {

constexpr auto kNoStructure = static_cast<std::int32_t>(Structure::None),
               kPlanar = static_cast<std::int32_t>(Structure::Planar);

// The gates as numbers; switches are 1 or 0.
struct GateNumbers {
  float rotation[9];  // row by row
  float translation[3];
  float max_distance_sq, min_cosine;
  std::int32_t compares_angles, same_structure, signed_normals;
};

struct Candidates {
  alignas(64) Column<float> source_point[3], target_point[3], source_direction[3], target_direction[3];
  alignas(64) Column<std::int32_t> source_structure, target_structure;
  alignas(64) std::int32_t passes[kGatheredAtOnce];  // 1 or 0
};

AUGICP_VECTORIZED void test_distances(const GateNumbers& __restrict gates, Candidates& __restrict c) {
  const float* const r = gates.rotation;
  const float* const t = gates.translation;
  for (std::size_t k = 0; k < kGatheredAtOnce; ++k) {
    const float px = c.source_point[0][k], py = c.source_point[1][k], pz = c.source_point[2][k];
    const float x = c.target_point[0][k] - (r[0] * px + r[1] * py + r[2] * pz + t[0]);
    const float y = c.target_point[1][k] - (r[3] * px + r[4] * py + r[5] * pz + t[1]);
    const float z = c.target_point[2][k] - (r[6] * px + r[7] * py + r[8] * pz + t[2]);
    c.passes[k] = x * x + y * y + z * z <= gates.max_distance_sq ? 1 : 0;
  }
}

AUGICP_VECTORIZED void test_directions(const GateNumbers& __restrict gates, Candidates& __restrict c) {
  const float* const r = gates.rotation;
  const std::int32_t compares_angles = gates.compares_angles, same_structure = gates.same_structure;
  for (std::size_t k = 0; k < kGatheredAtOnce; ++k) {
    const float lx = c.source_direction[0][k], ly = c.source_direction[1][k], lz = c.source_direction[2][k];
    const float cosine = c.target_direction[0][k] * (r[0] * lx + r[1] * ly + r[2] * lz) +
                         c.target_direction[1][k] * (r[3] * lx + r[4] * ly + r[5] * lz) +
                         c.target_direction[2][k] * (r[6] * lx + r[7] * ly + r[8] * lz);
    const std::int32_t of_source = c.source_structure[k], of_target = c.target_structure[k];
    const bool with_sign = (gates.signed_normals != 0) & (of_target == kPlanar);
    const float likeness = with_sign ? cosine : std::abs(cosine);
    const bool both = (of_source != kNoStructure) & (of_target != kNoStructure), alike = of_source == of_target;
    const bool is_unlike = (same_structure != 0) & both & !alike;
    const bool is_turned = (compares_angles != 0) & both & alike & !(likeness >= gates.min_cosine);
    c.passes[k] &= (is_unlike | is_turned) ? 0 : 1;
  }
}

void append(const std::uint32_t* sources, const std::uint32_t* targets, std::size_t count,
            std::vector<Correspondence>& pairs) {
  const std::size_t before = pairs.size();
  pairs.resize(before + count);
  for (std::size_t k = 0; k < count; ++k) pairs[before + k] = {sources[k], targets[k]};
}

// passes: 1 or 0 for each candidate.
void append_some(const std::uint32_t* sources, const std::uint32_t* targets, const std::int32_t* passes,
                 std::size_t count, std::vector<Correspondence>& pairs) {
  std::uint32_t of_source[kGatheredAtOnce], of_target[kGatheredAtOnce];
  std::size_t num_passing = 0;
  for (std::size_t k = 0; k < count; ++k) {  // no branch: it would be unpredictable
    of_source[num_passing] = sources[k];
    of_target[num_passing] = targets[k];
    num_passing += static_cast<std::size_t>(passes[k]);
  }
  append(of_source, of_target, num_passing, pairs);
}

}  // namespace

void Gates::check() const {
  require(max_distance > 0.0, "max_distance", max_distance, "must be above 0");
  require(max_angle > 0.0, "max_angle", max_angle, "must be above 0");
}

void AgreementTolerance::check() const {
  require_not_negative("tolerance.distance", distance);
  require_not_negative("tolerance.per_depth", per_depth);
  require(distance + per_depth > 0.0, "tolerance.distance", distance, "must be above 0 where per_depth is not");
  require(min_cosine >= -1.0 && min_cosine <= 1.0, "tolerance.min_cosine", min_cosine, "must be from -1 to 1");
}

PairFilter::PairFilter(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, const Gates& gates)
    : source_(source),
      target_(target),
      pose_(target_from_source),
      max_distance_sq_(static_cast<float>(gates.max_distance * gates.max_distance)),
      min_cosine_(static_cast<float>(std::cos(std::min(gates.max_angle, std::numbers::pi)))),
      compares_angles_(gates.max_angle < std::numbers::pi && source.has_directions() && target.has_directions()),
      same_structure_(gates.same_structure && source.has_directions() && target.has_directions()),
      signed_normals_(normals_have_signs(source, target)) {}

void PairFilter::append_passing(const IndexRuns& sources, const IndexRuns& targets,
                                std::vector<Correspondence>& pairs) const {
  GateNumbers gates{{}, {}, max_distance_sq_, min_cosine_, compares_angles_, same_structure_, signed_normals_};
  for (int i = 0; i < 9; ++i) gates.rotation[i] = pose_.rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) gates.translation[i] = pose_.translation[i];
  Candidates candidates{};  // entries beyond the last pair are computed too
  gather(source_.points, sources, candidates.source_point);
  gather(target_.points, targets, candidates.target_point);
  test_distances(gates, candidates);
  if (compares_angles_ || same_structure_) {
    gather(source_.structures, sources, candidates.source_structure);
    gather(target_.structures, targets, candidates.target_structure);
    gather(source_.directions, sources, candidates.source_direction);
    gather(target_.directions, targets, candidates.target_direction);
    test_directions(gates, candidates);
  }
  const auto num_passing = std::accumulate(candidates.passes, candidates.passes + sources.count, std::int32_t{0});
  if (static_cast<std::size_t>(num_passing) == sources.count)
    append(sources.index, targets.index, sources.count, pairs);
  else
    append_some(sources.index, targets.index, candidates.passes, sources.count, pairs);
}

}  // namespace augicp
