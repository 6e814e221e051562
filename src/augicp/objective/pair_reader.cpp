// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_reader.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/vectorized.h"
#include "augicp/objective/pair_vectors.h"

namespace augicp {
namespace {

constexpr auto kNone = static_cast<std::int32_t>(Structure::None),
               kPlanar = static_cast<std::int32_t>(Structure::Planar);

AUGICP_VECTORIZED void move_batch(const PairModel& __restrict model, PairBatch& __restrict b) {
  const double* const t = model.translation;
  float rotation[9];
  for (int i = 0; i < 9; ++i) rotation[i] = static_cast<float>(model.rotation[i]);
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecd q = sum(turned(model.rotation, wide(at(b.source_point, k))), {t[0], t[1], t[2]});
    put(b.moved_point, k, q);
    put(b.position_error, k, difference(wide(at(b.target_point, k)), q));
  }
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecf d = at(b.target_direction, k), l = turned(rotation, at(b.source_direction, k));
    // Eq. (7), but with the sign chosen first: a tangent and its opposite are the same edge.
    const bool is_opposite = (dot(l, d) < 0.0f) & ((b.structure[k] != kPlanar) | (model.one_sided == 0.0f));
    const Vecf m = scaled(is_opposite ? -1.0f : 1.0f, l);
    put(b.moved_direction, k, m);
    put(b.direction_error, k, difference(d, m));
  }
}

AUGICP_VECTORIZED void weigh_batch(const PairModel& __restrict model, PairBatch& __restrict b) {
  const ByStructure along = model.along, across = model.across, direction_along = model.direction_along,
                    direction_across = model.direction_across;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const std::int32_t structure = b.structure[k];
    // Where the structures differ the linear error has no meaning: Omega^l = 0.
    const bool is_alike = (structure != kNone) & (structure == b.source_structure[k]);
    b.compares[k] = is_alike ? 1.0f : 0.0f;
    const float weight = b.weight[k], compared = b.compares[k] * weight;
    b.along[k] = weight * along.of(structure);
    b.across[k] = weight * across.of(structure);
    b.direction_along[k] = compared * direction_along.of(structure);
    b.direction_across[k] = compared * direction_across.of(structure);
  }
}

// A power of two about the largest information, so that the numbers in it have the same digits.
double unit_of(const InformationModel& model) {
  double largest = 0.0;
  for (const StructureInformation* row : {&model.none, &model.planar, &model.edge})
    for (const Information& information : {row->position, row->direction})
      largest = std::max({largest, information.along, information.across});
  return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest)) : 1.0;
}

PairModel pair_model(const Rigid3& pose, const InformationModel& information, double unit, bool signed_normals) {
  PairModel model{};
  const Mat3d rotation = pose.rotation.toRotationMatrix();
  for (int i = 0; i < 9; ++i) model.rotation[i] = rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) model.translation[i] = pose.translation[i];
  const auto table = [&](Information StructureInformation::*part, double Information::*number) {
    const auto of = [&](const StructureInformation& row) { return static_cast<float>(row.*part.*number / unit); };
    return ByStructure{of(information.none), of(information.planar), of(information.edge)};
  };
  model.along = table(&StructureInformation::position, &Information::along);
  model.across = table(&StructureInformation::position, &Information::across);
  model.direction_along = table(&StructureInformation::direction, &Information::along);
  model.direction_across = table(&StructureInformation::direction, &Information::across);
  model.one_sided = signed_normals ? 1.0f : 0.0f;
  return model;
}

// Runs are read in whole units: behind the last pair there may be any points. Zero times what they overflow to would
// not be zero.
void clear_behind(std::size_t count, PairBatch& batch) {
  for (auto* vectors : {&batch.source_point, &batch.source_direction, &batch.target_point, &batch.target_direction})
    for (auto& column : *vectors) std::fill(column + count, column + kPairsPerBatch, 0.0f);
  std::fill(batch.weight + count, batch.weight + kPairsPerBatch, 0.0f);
}

}  // namespace

PairReader::PairReader(const PosedPairs& posed, const InformationModel& information)
    : source_(posed.source),
      target_(posed.target),
      information_unit_(unit_of(information)),
      model_(pair_model(posed.target_from_source, information, information_unit_,
                        normals_have_signs(posed.source, posed.target))),
      compares_directions_(posed.source.has_directions() && posed.target.has_directions()) {}

void PairReader::read(std::span<const Correspondence> pairs, PairBatch& batch) const {
  IndexRuns of_source, of_target;
  find_runs(pairs, of_source, of_target);
  gather(source_.points, of_source, batch.source_point);
  gather(target_.points, of_target, batch.target_point);
  if (target_.weights.empty())
    std::fill_n(batch.weight, pairs.size(), 1.0f);
  else
    gather(target_.weights, of_target, batch.weight);
  if (target_.has_directions()) {
    gather(target_.directions, of_target, batch.target_direction);
    gather(target_.structures, of_target, batch.structure);
  }
  if (compares_directions_) {
    gather(source_.directions, of_source, batch.source_direction);
    gather(source_.structures, of_source, batch.source_structure);
  }
  clear_behind(pairs.size(), batch);
  move_batch(model_, batch);
  weigh_batch(model_, batch);
}

}  // namespace augicp
