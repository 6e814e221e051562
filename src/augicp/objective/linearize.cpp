// SPDX-License-Identifier: MIT
#include "augicp/objective/linearize.h"

#include <algorithm>
#include <limits>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/objective/pair_reader.h"

namespace augicp {
namespace {

// The sums of a block: kLanes of each, so that additions need not wait for each other.
class BlockSums {
 public:
  void add(const PairTerms& terms) { add_terms(terms, lanes_); }

  BlockSums& operator+=(const BlockSums& other) {
    for (int t = 0; t < PairTerms::kCount; ++t)
      for (int lane = 0; lane < kLanes; ++lane) lanes_[t][lane] += other.lanes_[t][lane];
    return *this;
  }

  double of(int term) const {
    const auto& l = lanes_[term];
    return ((l[0] + l[1]) + (l[2] + l[3])) + ((l[4] + l[5]) + (l[6] + l[7]));
  }

 private:
  TermLanes lanes_ = {};
};

Mat3d symmetric(const BlockSums& sums, int first) {
  Mat3d m;
  for (int row = 0, term = first; row < 3; ++row)
    for (int column = row; column < 3; ++column, ++term) m(row, column) = m(column, row) = sums.of(term);
  return m;
}

NormalEquations equations_of(const BlockSums& sums, double unit) {
  NormalEquations equations;
  const auto vector = [&](int first) { return Vec3d(sums.of(first), sums.of(first + 1), sums.of(first + 2)); };
  Mat3d tr;
  for (int i = 0; i < 9; ++i) tr(i / 3, i % 3) = sums.of(PairTerms::kTr + i);
  const Mat3d tt = symmetric(sums, PairTerms::kTt), rr = symmetric(sums, PairTerms::kRr);
  equations.H << tt, tr, tr.transpose(), rr;
  equations.b << vector(PairTerms::kBt), vector(PairTerms::kBr);
  equations.H *= unit;
  equations.b *= unit;
  equations.cost = unit * sums.of(PairTerms::kCost);
  return equations;
}

// So small a kernel, in the information's unit, is as good as zero, and chi2 over it still is a float.
constexpr double kLeastKernel = 1e-30;

float in_float(double number, double least) {
  return static_cast<float>(std::clamp<double>(number, least, std::numeric_limits<float>::max()));
}

// Of an objective, in the reader's unit.
struct Kernels {
  float chi2, direction_chi2;
};
Kernels kernels_of(const Objective& objective, double unit) {
  require(objective.kernel_chi2 > 0.0, "kernel_chi2", objective.kernel_chi2, "must be above 0");
  require(objective.kernel_direction_chi2 > 0.0, "kernel_direction_chi2", objective.kernel_direction_chi2,
          "must be above 0");
  return {in_float(objective.kernel_chi2 / unit, kLeastKernel),
          in_float(objective.kernel_direction_chi2 / unit, kLeastKernel)};
}

// Calls body(first pair, count, batch) for all pairs of [begin, end).
template <typename Body>
void for_each_batch(const PairReader& reader, std::span<const Correspondence> pairs, std::size_t begin, std::size_t end,
                    const Body& body) {
  PairBatch batch;
  for (std::size_t first = begin; first < end; first += kPairsPerBatch) {
    const std::size_t count = std::min<std::size_t>(kPairsPerBatch, end - first);
    reader.read(pairs.subspan(first, count), batch);
    body(first, count, batch);
  }
}

}  // namespace

NormalEquations linearize(const PosedPairs& posed, const Objective& objective, int num_threads) {
  const PairReader reader(posed, objective.information);
  const double unit = reader.information_unit();
  const Kernels kernels = kernels_of(objective, unit);
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    BlockSums block;
    PairTerms terms;
    for_each_batch(reader, posed.pairs, begin, end, [&](std::size_t, std::size_t, const PairBatch& batch) {
      terms_of(batch, kernels.chi2, kernels.direction_chi2, terms);
      block.add(terms);
    });
    return block;
  };
  const BlockSums sums = blocked_sum<BlockSums>(posed.size(), num_threads, sums_of, kLightBlockSize);
  NormalEquations equations = equations_of(sums, unit);
  equations.num_pairs = static_cast<std::int64_t>(posed.size());
  if (objective.intensity.information > 0.0) equations += linearize_intensity(posed, objective.intensity, num_threads);
  return equations;
}

std::vector<Vec6d> gradients_of_groups(const PosedPairs& posed, std::span<const std::size_t> begin,
                                       const Objective& objective, int num_threads) {
  const PairReader reader(posed, objective.information);
  const double unit = reader.information_unit();
  const Kernels kernels = kernels_of(objective, unit);
  std::vector<Vec6d> gradients(begin.size() - 1, Vec6d::Zero());
  const auto add_up = [&](std::size_t first_group, std::size_t end_group) {
    PairTerms terms;
    std::size_t group = first_group;
    const auto add = [&](std::size_t first, std::size_t count, const PairBatch& batch) {
      terms_of(batch, kernels.chi2, kernels.direction_chi2, terms);
      for (std::size_t k = 0; k < count; ++k) {
        while (first + k >= begin[group + 1]) ++group;
        for (int row = 0; row < 6; ++row)
          gradients[group][row] += unit * static_cast<double>(terms.term[PairTerms::kBt + row][k]);
      }
    };
    for_each_batch(reader, posed.pairs, begin[first_group], begin[end_group], add);
    if (!(objective.intensity.information > 0.0)) return;
    for (group = first_group; group < end_group; ++group) {
      const auto of_group = posed.pairs.subspan(begin[group], begin[group + 1] - begin[group]);
      gradients[group] += linearize_intensity(posed.with(of_group), objective.intensity, 1).b;
    }
  };
  constexpr std::size_t kGroupsPerBlock = 256;
  for_each_block(gradients.size(), num_threads, add_up, kGroupsPerBlock);
  return gradients;
}

PairChi2 chi2_of_pairs(const PosedPairs& posed, const InformationModel& information, int num_threads) {
  const PairReader reader(posed, information);
  const double unit = reader.information_unit();
  const auto in_unit = [&](float number) { return in_float(unit * static_cast<double>(number), 0.0); };
  PairChi2 chi2{std::vector<float>(posed.size()), std::vector<float>(posed.size())};
  const auto write_chi2 = [&](std::size_t begin, std::size_t end) {
    BatchChi2 of_batch;
    for_each_batch(reader, posed.pairs, begin, end, [&](std::size_t first, std::size_t count, const PairBatch& batch) {
      chi2_of(batch, of_batch);
      for (std::size_t k = 0; k < count; ++k) {
        chi2.position[first + k] = in_unit(of_batch.position[k]);
        chi2.direction[first + k] = batch.compares[k] > 0.0f ? in_unit(of_batch.direction[k]) : -1.0f;
      }
    });
  };
  for_each_block(posed.size(), num_threads, write_chi2);
  return chi2;
}

}  // namespace augicp
