// SPDX-License-Identifier: MIT
#include "augicp/odometry/standstill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "augicp/geometry/rotation.h"

namespace augicp {
namespace {

constexpr double kNoise_m = 0.005, kNoise_rad = 0.0003;

Mat6d covariance() {
  Vec6d variances;
  variances << Vec3d::Constant(kNoise_m * kNoise_m), Vec3d::Constant(kNoise_rad * kNoise_rad);
  return variances.asDiagonal();
}

// A pose as it is measured far from the world's zero.
class Sensor {
 public:
  explicit Sensor(unsigned seed) : generator_(seed) {}
  Rigid3 measured_at(double distance) {
    const Vec3d place = kStart + Vec3d(distance, 0.0, 0.0) + noise(kNoise_m);
    return {rotation_exp(noise(kNoise_rad)) * rotation_exp({0.0, 0.0, 1.0}), place};
  }
  inline static const Vec3d kStart{100.0, -50.0, 2.0};

 private:
  Vec3d noise(double deviation) {
    std::normal_distribution<double> normal(0.0, deviation);
    return {normal(generator_), normal(generator_), normal(generator_)};
  }
  std::mt19937 generator_;
};

double error_of(const Rigid3& pose, double distance) {
  return (pose.translation - Sensor::kStart - Vec3d(distance, 0.0, 0.0)).norm();
}

TEST(Standstill, TheMeanOfItsPosesIsNearerThanEach) {
  double sum_sq = 0.0, sum_sq_single = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Sensor sensor(seed);
    Standstill standstill;
    for (int k = 0; k < 30; ++k) {
      const Rigid3 single = sensor.measured_at(0.0);
      const double error = error_of(standstill.add(single, covariance()), 0.0);
      if (k < 10) continue;
      sum_sq += error * error;
      sum_sq_single += error_of(single, 0.0) * error_of(single, 0.0);
    }
  }
  EXPECT_LT(sum_sq, 0.3 * sum_sq_single);
}

TEST(Standstill, AMotionBeyondItsCertaintyIsBelievedAtOnce) {
  Sensor sensor(1);
  Standstill standstill;
  for (int k = 0; k < 10; ++k) standstill.add(sensor.measured_at(0.0), covariance());
  const Rigid3 moved = sensor.measured_at(0.04);
  EXPECT_EQ(standstill.add(moved, covariance()).translation, moved.translation);
}

TEST(Standstill, WhoCreepsIsFollowedWithinTheNoise) {
  for (const double step_m : {0.0005, 0.001, 0.002, 0.005, 0.01})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Sensor sensor(seed);
      Standstill standstill;
      for (int k = 0; k < 100; ++k) {
        const double distance = std::max(0, k - 20) * step_m;
        // A mean is off by less than a motion that is believed at once, which is below five deviations, and by noise.
        EXPECT_LT(error_of(standstill.add(sensor.measured_at(distance), covariance()), distance), 7.0 * kNoise_m)
            << step_m;
      }
    }
}

// A first pose is exact, because it defines the world.
TEST(Standstill, AnExactPoseMayBeTheFirst) {
  Sensor sensor(1);
  Standstill standstill;
  standstill.add({rotation_exp({0.0, 0.0, 1.0}), Sensor::kStart}, Mat6d::Zero());
  const Rigid3 second = sensor.measured_at(0.0);
  EXPECT_NEAR(error_of(standstill.add(second, covariance()), 0.0), 0.5 * error_of(second, 0.0), 1e-9);
}

}  // namespace
}  // namespace augicp
