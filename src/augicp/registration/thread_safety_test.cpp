// SPDX-License-Identifier: MIT
// robustness 16: registrations at the same time in one program do not disturb one another. scripts/test runs this with
// the thread sanitizer too.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <thread>
#include <vector>

#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace augicp {
namespace {

constexpr int kNumPairs = 64;

// Depth images and, every other time, bare clouds; no two pairs are of the same room.
testing::ScanPair pair_of_room(unsigned number) {
  std::mt19937 generator(number);
  const Rigid3 motion = testing::random_motion(generator, 0.1, 0.1);
  const testing::Scene scene = testing::room(number);
  constexpr int kWidth = 40;
  const Scan source = testing::noisy_view(scene, scene.world_from_camera * motion, 1, kWidth);
  const Scan target = testing::noisy_view(scene, scene.world_from_camera, 2, kWidth);
  if (number % 2 == 0) return {source, target, motion};
  return {scan_of(source.cloud), scan_of(target.cloud), motion};
}

void expect_same_bits(const AlignResult& a, const AlignResult& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.num_pairs, b.num_pairs);
  EXPECT_EQ(a.target_from_source.matrix(), b.target_from_source.matrix());
  EXPECT_EQ(a.information, b.information);
}

TEST(Registration, ThreadsOfTheCallerDoNotMeet) {
  std::vector<testing::ScanPair> pairs;
  for (unsigned number = 1; number <= kNumPairs; ++number) pairs.push_back(pair_of_room(number));
  RegistrationOptions options;
  options.search = false;
  options.max_iterations = 5;  // races need no more, and the thread sanitizer is slow
  options.num_threads = 2;     // of each call: callers' threads and the library's together
  const auto result_of = [&](const testing::ScanPair& pair) {
    return register_scans(pair.source, pair.target, Rigid3{}, options).result;
  };
  std::vector<AlignResult> at_once(kNumPairs);
  {
    std::vector<std::jthread> callers;
    for (std::size_t k = 0; k < pairs.size(); ++k) callers.emplace_back([&, k] { at_once[k] = result_of(pairs[k]); });
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) expect_same_bits(at_once[k], result_of(pairs[k]));
}

}  // namespace
}  // namespace augicp
