// SPDX-License-Identifier: MIT
#include "augicp/experiment/verdict.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "augicp/core/check.h"
#include "augicp/core/error.h"
#include "augicp/experiment/random.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/registration.h"

namespace augicp {
namespace {

// True overlap is counted with twice the tolerance of the verdict, for truth has errors too; less than this is none.
constexpr double kOverlapPerDepth = 0.03;
constexpr double kNoOverlap = 0.01;

Scan read_frame(const VerdictSequence& from, std::size_t frame, int pixel_step) {
  DepthSequenceReader reader({from.sequence.frames[frame]}, from.sequence.depth_scale);
  const std::optional<DepthFrame> read = reader.next();
  if (!read->problem.empty()) throw IoError(read->problem);
  return scan_of(read->image, from.camera, pixel_step);
}

Scan bare(const Scan& scan) {
  Cloud cloud;
  cloud.points = scan.cloud.points;
  return scan_of(std::move(cloud));
}

double overlap_of(const Scan& source, const Scan& target, const Rigid3& target_from_source) {
  const AgreementTolerance tolerance{.distance = 0.0, .per_depth = kOverlapPerDepth};
  const Agreement count = matcher_for(target, true, {})->agreement(source.cloud, target_from_source, tolerance, 1);
  return count.total() > 0 ? static_cast<double>(count.agree) / static_cast<double>(count.total()) : 0.0;
}

// Frames of depth images have their origins at zero, as the covariance asks for.
std::optional<double> nees(const AlignResult& result, const Rigid3& truth) {
  if (!result.covariance) return std::nullopt;
  const Vec6d error = increment_between(truth, result.target_from_source);
  return error.dot(result.covariance->ldlt().solve(error)) / 6.0;
}

PairTruth truth_of(const VerdictPair& pair, const VerdictOptions& options) {
  if (!pair.error || pair.true_overlap < kNoOverlap) return PairTruth::Apart;
  const PoseError twice{2.0 * options.right.translation, 2.0 * options.right.rotation};
  if (!is_within(*pair.error, twice)) return PairTruth::Wrong;
  if (!is_within(*pair.error, options.right)) return PairTruth::Near;
  return pair.true_overlap < options.min_true_overlap ? PairTruth::RightLittle : PairTruth::Right;
}

std::optional<Rigid3> true_motion(const VerdictSequence& in, std::size_t target, std::size_t source, double offset_s) {
  const auto pose = [&](std::size_t frame) {
    return pose_at(*in.sequence.truth, in.sequence.frames[frame].stamp_s + offset_s, kMaxTruthGap_s);
  };
  const auto world_from_target = pose(target), world_from_source = pose(source);
  if (!world_from_target || !world_from_source) return std::nullopt;
  return inverse(*world_from_target) * *world_from_source;
}

void register_pair(const Scan& source, const Scan& target, const std::optional<Rigid3>& truth,
                   const VerdictOptions& options, VerdictPair& pair) {
  const AlignResult result = options.as_clouds
                                 ? register_scans(bare(source), bare(target), {}, options.registration).result
                                 : register_scans(source, target, {}, options.registration).result;
  pair.status = result.status;
  pair.doubts = result.doubts;
  pair.evidence = result.evidence;
  const bool ended = static_cast<int>(result.history.size()) < options.registration.max_iterations;
  const bool by_verdict = result.status == AlignStatus::Doubtful || result.status == AlignStatus::Ambiguous ||
                          result.status == AlignStatus::Converged;
  pair.without_verdict = !by_verdict ? result.status : ended ? AlignStatus::Converged : AlignStatus::IterationLimit;
  if (truth) {
    pair.error = pose_error(result.target_from_source, *truth);
    pair.nees = nees(result, *truth);
    pair.true_overlap = overlap_of(source, target, *truth);
  }
  pair.truth = truth_of(pair, options);
}

// Targets of one sequence at a gap.
std::vector<std::size_t> targets_of(const VerdictSequence& in, std::size_t gap, const VerdictOptions& options) {
  std::vector<std::size_t> targets;
  if (!in.sequence.truth) return targets;
  for (std::size_t i = 0; i + gap < in.sequence.frames.size(); i += options.every)
    if (true_motion(in, i, i + gap, options.time_offset_s)) targets.push_back(i);
  return targets;
}

VerdictPair pair_of(const VerdictSequence& target, std::size_t target_frame, const VerdictSequence& source,
                    std::size_t source_frame) {
  VerdictPair pair;
  pair.target_sequence = target.name;
  pair.source_sequence = source.name;
  pair.target = target_frame;
  pair.source = source_frame;
  return pair;
}

VerdictPair pair_across(std::span<const VerdictSequence> sequences, const VerdictOptions& options,
                        std::mt19937& generator) {
  const auto draw = [&](std::size_t count) {
    return static_cast<std::size_t>(uniform(generator, 0.0, static_cast<double>(count)));
  };
  const std::size_t to = draw(sequences.size());
  const std::size_t from = (to + 1 + draw(sequences.size() - 1)) % sequences.size();
  const VerdictSequence &target = sequences[to], &source = sequences[from];
  const std::size_t target_frame = draw(target.sequence.frames.size()),
                    source_frame = draw(source.sequence.frames.size());
  VerdictPair pair = pair_of(target, target_frame, source, source_frame);
  register_pair(read_frame(source, pair.source, options.pixel_step),
                read_frame(target, pair.target, options.pixel_step), std::nullopt, options, pair);
  return pair;
}

double part(std::size_t count, std::size_t whole) {
  return whole > 0 ? static_cast<double>(count) / static_cast<double>(whole) : 0.0;
}

// Accepted when the strain may be larger: the status is Converged, or Doubtful of a loop that had settled.
double least_strain_accepting(const VerdictPair& pair) {
  const bool may_be = pair.status == AlignStatus::Converged || pair.status == AlignStatus::Doubtful;
  const bool settled = pair.evidence && (pair.without_verdict == AlignStatus::Converged || has_settled(*pair.evidence));
  return may_be && settled ? strain(*pair.evidence) : std::numeric_limits<double>::infinity();
}

}  // namespace

void VerdictOptions::check() const {
  for (const std::size_t gap : gaps) require(gap >= 1, "gaps", static_cast<double>(gap), "must be at least 1");
  require(every >= 1, "every", static_cast<double>(every), "must be at least 1");
  require(pixel_step >= 1, "pixel_step", pixel_step, "must be at least 1");
  registration.check();
}

std::size_t num_pairs(std::span<const VerdictSequence> sequences, const VerdictOptions& options) {
  std::size_t count = sequences.size() > 1 ? options.num_across : 0;
  for (const VerdictSequence& in : sequences)
    for (const std::size_t gap : options.gaps) count += targets_of(in, gap, options).size();
  return count;
}

std::vector<VerdictPair> run_verdict(std::span<const VerdictSequence> sequences, const VerdictOptions& options,
                                     const std::function<void()>& on_pair) {
  options.check();
  std::vector<VerdictPair> pairs;
  for (const VerdictSequence& in : sequences)
    for (const std::size_t gap : options.gaps)
      for (const std::size_t target : targets_of(in, gap, options)) {
        pairs.push_back(pair_of(in, target, in, target + gap));
        register_pair(read_frame(in, target + gap, options.pixel_step), read_frame(in, target, options.pixel_step),
                      true_motion(in, target, target + gap, options.time_offset_s), options, pairs.back());
        on_pair();
      }
  std::mt19937 generator(options.seed);
  for (std::size_t k = 0; sequences.size() > 1 && k < options.num_across; ++k) {
    pairs.push_back(pair_across(sequences, options, generator));
    on_pair();
  }
  return pairs;
}

std::vector<ConfusionRow> confusion(std::span<const VerdictPair> pairs) {
  std::vector<ConfusionRow> rows(5);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].truth = static_cast<PairTruth>(k);
  for (const VerdictPair& pair : pairs) {
    ConfusionRow& row = rows[static_cast<std::size_t>(pair.truth)];
    ++row.num_pairs;
    row.num_converged_without_verdict += pair.without_verdict == AlignStatus::Converged;
    ++(pair.status == AlignStatus::Converged        ? row.num_converged
       : pair.status == AlignStatus::Doubtful       ? row.num_doubtful
       : pair.status == AlignStatus::Ambiguous      ? row.num_doubtful
       : pair.status == AlignStatus::Degenerate     ? row.num_degenerate
       : pair.status == AlignStatus::IterationLimit ? row.num_iteration_limit
                                                    : row.num_failed);
  }
  return rows;
}

std::vector<RocPoint> roc(std::span<const VerdictPair> pairs) {
  std::array<std::vector<double>, 5> least;  // of each truth
  for (const VerdictPair& pair : pairs)
    least[static_cast<std::size_t>(pair.truth)].push_back(least_strain_accepting(pair));
  const auto accepted = [&](PairTruth truth, double limit) {
    const std::vector<double>& all = least[static_cast<std::size_t>(truth)];
    return part(static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](double s) { return s <= limit; })),
                all.size());
  };
  std::vector<RocPoint> points;
  for (double limit = 0.05; limit < 12.0; limit *= 1.05)
    points.push_back({limit, accepted(PairTruth::Apart, limit), accepted(PairTruth::Wrong, limit),
                      1.0 - accepted(PairTruth::Right, limit)});
  return points;
}

}  // namespace augicp
