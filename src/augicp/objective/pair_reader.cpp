// SPDX-License-Identifier: MIT
#include "augicp/objective/pair_reader.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "augicp/core/vectorized.h"
#include "augicp/objective/pair_vectors.h"

namespace augicp {
namespace {

constexpr auto kPlanar = static_cast<std::int32_t>(Structure::Planar);

AUGICP_VECTORIZED void move_batch(const PairModel& __restrict model, PairBatch& __restrict b) {
  const double* const t = model.translation;
  float rotation[9];
  for (int i = 0; i < 9; ++i) rotation[i] = static_cast<float>(model.rotation[i]);
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecd q = sum(turned(model.rotation, wide(at(b.source_point, k))), {t[0], t[1], t[2]});
    put(b.moved_point, k, q);
    put(b.position_error, k, difference(wide(at(b.target_point, k)), q));
  }
  const bool signed_normals = model.signed_normals;
  for (int k = 0; k < kPairsPerBatch; ++k) {
    const Vecf d = at(b.target_direction, k), l = turned(rotation, at(b.source_direction, k));
    // Eq. (7), but with the sign chosen first: a tangent and its opposite are the same edge.
    const bool is_opposite = (dot(l, d) < 0.0f) & ((b.structure[k] != kPlanar) | !signed_normals);
    const Vecf m = scaled(is_opposite ? -1.0f : 1.0f, l);
    put(b.moved_direction, k, m);
    put(b.direction_error, k, difference(d, m));
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

PairModel pair_model(const Rigid3& pose, const InformationModel& information, double unit, bool has_directions,
                     bool signed_normals) {
  PairModel model{};
  const Mat3d rotation = pose.rotation.toRotationMatrix();
  for (int i = 0; i < 9; ++i) model.rotation[i] = rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) model.translation[i] = pose.translation[i];
  const auto table = [&](Information StructureInformation::*part, Sides sides) {
    const bool has_sides = sides != Sides::Both || has_directions;
    return information_table(information, part, has_sides ? sides : Sides::Target, unit);
  };
  model.positions = table(&StructureInformation::position, information.position_sides);
  model.directions = table(&StructureInformation::direction, information.direction_sides);
  model.signed_normals = signed_normals;
  return model;
}

// Runs are read in whole units: behind the last pair there may be any points. Zero times what they overflow to would
// not be zero.
void clear_behind(std::size_t count, PairBatch& batch) {
  for (auto* vectors : {&batch.source_point, &batch.source_direction, &batch.target_point, &batch.target_direction})
    for (auto& column : *vectors) std::fill(column + count, column + kPairsPerBatch, 0.0f);
  for (auto* weights : {&batch.weight, &batch.source_weight})
    std::fill(*weights + count, *weights + kPairsPerBatch, 0.0f);
}

// Eq. (2): the error of a pair is that from the mean.
void read_means(std::span<const PointGaussian> of_target, std::span<const Correspondence> pairs, PairBatch& batch) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Vec3f& mean = of_target[pairs[k].target].mean;
    put(batch.target_point, static_cast<int>(k), Vecf{mean.x(), mean.y(), mean.z()});
  }
}

void gather_weights(std::span<const float> weights, const IndexRuns& runs, std::size_t count, Column<float>& column) {
  if (weights.empty())
    std::fill_n(column, count, 1.0f);
  else
    gather(weights, runs, column);
}

}  // namespace

PairReader::PairReader(const PosedPairs& posed, const InformationModel& information)
    : source_(posed.source),
      target_(posed.target),
      information_unit_(unit_of(information)),
      compares_directions_(posed.source.has_directions() && posed.target.has_directions()),
      model_(pair_model(posed.target_from_source, information, information_unit_, compares_directions_,
                        normals_have_signs(posed.source, posed.target))) {
  assert(!weighs_by_gaussians() || target_.empty() || target_.has_gaussians());
}

void PairReader::read(std::span<const Correspondence> pairs, PairBatch& batch) const {
  IndexRuns of_source, of_target;
  find_runs(pairs, of_source, of_target);
  gather(source_.points, of_source, batch.source_point);
  gather(target_.points, of_target, batch.target_point);
  gather_weights(target_.weights, of_target, pairs.size(), batch.weight);
  gather_weights(source_.weights, of_source, pairs.size(), batch.source_weight);
  if (target_.has_directions()) {
    gather(target_.directions, of_target, batch.target_direction);
    gather(target_.structures, of_target, batch.structure);
  }
  if (compares_directions_) {
    gather(source_.directions, of_source, batch.source_direction);
    gather(source_.structures, of_source, batch.source_structure);
  }
  if (weighs_by_gaussians()) read_means(target_.gaussians, pairs, batch);
  clear_behind(pairs.size(), batch);
  move_batch(model_, batch);
  if (weighs_by_gaussians())
    weigh_by_gaussians(target_.gaussians, pairs, static_cast<float>(1.0 / information_unit_), batch);
  else
    weigh_positions(model_.positions, batch);
  weigh_directions(model_.directions, batch);
}

}  // namespace augicp
