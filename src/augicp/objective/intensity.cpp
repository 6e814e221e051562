// SPDX-License-Identifier: MIT
#include "augicp/objective/intensity.h"

#include <cmath>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

class PairIntensity {
 public:
  PairIntensity(const Cloud& source, const Cloud& target, const Rigid3& target_from_source)
      : source_(source),
        target_(target),
        rotation_(target_from_source.rotation.toRotationMatrix()),
        translation_(target_from_source.translation) {}

  Vec3d moved(const Correspondence& pair) const {
    return rotation_ * source_.points[pair.source].cast<double>() + translation_;
  }
  Vec3d gradient(const Correspondence& pair) const { return target_.intensity_gradients[pair.target].cast<double>(); }

  // NaN where it is not known. Without a gradient a pair says nothing of the pose.
  double residual(const Correspondence& pair, const Vec3d& q, const Vec3d& g) const {
    if (g.isZero(0.0)) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(target_.intensities[pair.target]) + g.dot(q - target_.points[pair.target].cast<double>()) -
           static_cast<double>(source_.intensities[pair.source]);
  }

 private:
  const Cloud& source_;
  const Cloud& target_;
  Mat3d rotation_;
  Vec3d translation_;
};

struct Sums {
  NormalEquations equations;
  Vec6d weighted_jacobian = Vec6d::Zero();
  double weight = 0.0;

  void add(const Vec6d& jacobian, double r, const IntensityModel& model) {
    const double chi2 = model.information * r * r, kernel = model.kernel_chi2;
    const bool within = chi2 <= kernel;
    const double w = model.information * (within ? 1.0 : kernel / chi2);
    equations.H += w * jacobian * jacobian.transpose();
    equations.b += w * r * jacobian;
    equations.cost += 0.5 * (within ? chi2 : kernel * (1.0 + std::log(chi2 / kernel)));
    ++equations.num_intensity_pairs;
    weighted_jacobian += w * jacobian;
    weight += w;
  }

  Sums& operator+=(const Sums& other) {
    equations += other.equations;
    weighted_jacobian += other.weighted_jacobian;
    weight += other.weight;
    return *this;
  }
};

}  // namespace

void IntensityModel::check() const {
  require_not_negative("intensity information", information);
  require(kernel_chi2 > 0.0, "kernel_intensity_chi2", kernel_chi2, "must be above 0");
  require(std::isfinite(offset), "intensity offset", offset, "must be finite");
}

bool compares_intensities(const Cloud& source, const Cloud& target) {
  return source.has_intensities() && target.has_intensity_gradients();
}

std::vector<float> intensity_residuals(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                                       const Rigid3& target_from_source, int num_threads) {
  std::vector<float> residuals(pairs.size(), std::numeric_limits<float>::quiet_NaN());
  if (!compares_intensities(source, target)) return residuals;
  const PairIntensity of(source, target, target_from_source);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      residuals[k] = static_cast<float>(of.residual(pairs[k], of.moved(pairs[k]), of.gradient(pairs[k])));
  };
  for_each_block(pairs.size(), num_threads, measure, kLightBlockSize);
  return residuals;
}

NormalEquations linearize_intensity(const Cloud& source, const Cloud& target, std::span<const Correspondence> pairs,
                                    const Rigid3& target_from_source, const IntensityModel& model, int num_threads) {
  model.check();
  if (!compares_intensities(source, target)) return {};
  const PairIntensity of(source, target, target_from_source);
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    Sums sums;
    for (const Correspondence& pair : pairs.subspan(begin, end - begin)) {
      const Vec3d q = of.moved(pair), g = of.gradient(pair);
      const double r = of.residual(pair, q, g) - model.offset;
      if (std::isnan(r)) continue;
      Vec6d jacobian;
      jacobian << g, q.cross(g);
      sums.add(jacobian, r, model);
    }
    return sums;
  };
  Sums sums = blocked_sum<Sums>(pairs.size(), num_threads, sums_of, kLightBlockSize);
  const Vec6d& j = sums.weighted_jacobian;
  if (sums.weight > 0.0) sums.equations.H -= j * j.transpose() / sums.weight;
  return sums.equations;
}

}  // namespace augicp
