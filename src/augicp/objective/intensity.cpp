// SPDX-License-Identifier: MIT
#include "augicp/objective/intensity.h"

#include <cmath>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"

namespace augicp {
namespace {

class PairIntensity {
 public:
  explicit PairIntensity(const PosedPairs& posed)
      : source_(posed.source),
        target_(posed.target),
        rotation_(posed.target_from_source.rotation.toRotationMatrix()),
        translation_(posed.target_from_source.translation) {}

  Vec3d moved(const Correspondence& pair) const {
    return rotation_ * source_.points[pair.source].cast<double>() + translation_;
  }
  Vec3d gradient(const Correspondence& pair) const { return target_.intensity_gradients[pair.target].cast<double>(); }

  // NaN if it is unknown. A pair without a gradient does not constrain the pose.
  double residual(const Correspondence& pair, const Vec3d& q, const Vec3d& g) const {
    if (g.isZero(0.0)) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(target_.intensities[pair.target]) +
           g.dot(q - target_.points[pair.target].cast<double>()) -
           static_cast<double>(source_.intensities[pair.source]);
  }

 private:
  const Cloud& source_;
  const Cloud& target_;
  Mat3d rotation_;
  Vec3d translation_;
};

Vec6d jacobian_of(const Vec3d& gradient, const Vec3d& place) {
  Vec6d jacobian;
  jacobian << gradient, place.cross(gradient);
  return jacobian;
}

// Eq. (13), times the information.
double weight_of(double r, const IntensityModel& model) {
  const double chi2 = model.information * r * r;
  return model.information * (chi2 <= model.kernel_chi2 ? 1.0 : model.kernel_chi2 / chi2);
}

struct SharedSums {
  Mat6d products = Mat6d::Zero();
  Vec6d of_source = Vec6d::Zero(), of_target = Vec6d::Zero();
  double weight = 0.0;

  SharedSums& operator+=(const SharedSums& other) {
    products += other.products;
    of_source += other.of_source;
    of_target += other.of_target;
    weight += other.weight;
    return *this;
  }
};

struct Sums {
  NormalEquations equations;
  Vec6d weighted_jacobian = Vec6d::Zero();
  double weight = 0.0;

  void add(const Vec6d& jacobian, double r, const IntensityModel& model) {
    const double chi2 = model.information * r * r, kernel = model.kernel_chi2;
    const double w = weight_of(r, model);
    equations.H += w * jacobian * jacobian.transpose();
    equations.b += w * r * jacobian;
    equations.cost += 0.5 * (chi2 <= kernel ? chi2 : kernel * (1.0 + std::log(chi2 / kernel)));
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

std::vector<float> intensity_residuals(const PosedPairs& posed, int num_threads) {
  std::vector<float> residuals(posed.size(), std::numeric_limits<float>::quiet_NaN());
  if (!compares_intensities(posed.source, posed.target)) return residuals;
  const PairIntensity of(posed);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      residuals[k] =
          static_cast<float>(of.residual(posed.pairs[k], of.moved(posed.pairs[k]), of.gradient(posed.pairs[k])));
  };
  for_each_block(posed.size(), num_threads, measure, kLightBlockSize);
  return residuals;
}

NormalEquations linearize_intensity(const PosedPairs& posed, const IntensityModel& model, int num_threads) {
  model.check();
  if (!compares_intensities(posed.source, posed.target)) return {};
  const PairIntensity of(posed);
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    Sums sums;
    for (const Correspondence& pair : posed.pairs.subspan(begin, end - begin)) {
      const Vec3d q = of.moved(pair), g = of.gradient(pair);
      const double r = of.residual(pair, q, g) - model.offset;
      if (std::isnan(r)) continue;
      sums.add(jacobian_of(g, q), r, model);
    }
    return sums;
  };
  Sums sums = blocked_sum<Sums>(posed.size(), num_threads, sums_of, kLightBlockSize);
  const Vec6d& j = sums.weighted_jacobian;
  if (sums.weight > 0.0) sums.equations.H -= j * j.transpose() / sums.weight;
  return sums.equations;
}

Mat6d shared_intensity_information(const PosedPairs& posed, const IntensityModel& model, int num_threads) {
  model.check();
  if (!compares_intensities(posed.source, posed.target) || !posed.source.has_intensity_gradients())
    return Mat6d::Zero();
  const PairIntensity of(posed);
  const Mat3d rotation = posed.target_from_source.rotation.toRotationMatrix();
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    SharedSums sums;
    for (const Correspondence& pair : posed.pairs.subspan(begin, end - begin)) {
      const Vec3d q = of.moved(pair), g = of.gradient(pair);
      const double r = of.residual(pair, q, g) - model.offset;
      if (std::isnan(r)) continue;
      const double w = weight_of(r, model);
      const Vec6d seen = jacobian_of(rotation * posed.source.intensity_gradients[pair.source].cast<double>(), q);
      const Vec6d expected = jacobian_of(g, q);
      sums.products += w * seen * expected.transpose();
      sums.of_source += w * seen;
      sums.of_target += w * expected;
      sums.weight += w;
    }
    return sums;
  };
  const SharedSums sums = blocked_sum<SharedSums>(posed.size(), num_threads, sums_of, kLightBlockSize);
  if (!(sums.weight > 0.0)) return Mat6d::Zero();
  const Mat6d shared = sums.products - sums.of_source * sums.of_target.transpose() / sums.weight;
  return 0.5 * (shared + shared.transpose());
}

}  // namespace augicp
