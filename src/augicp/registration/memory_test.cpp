// SPDX-License-Identifier: MIT
#include "augicp/registration/memory.h"

#include <gmock/gmock.h>

#include <limits>
#include <regex>

#include "augicp/registration/registration.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// On the faces of a cube with edges of 2 m.
Scan box(std::size_t num_points, unsigned seed) {
  Cloud cloud = testing::random_points(num_points, 1.0, seed);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.points[i][i % 3] = i % 2 == 0 ? -1.0f : 1.0f;
  return scan_of(cloud);
}

RegistrationOptions with_lengths(std::optional<double> voxel_size, std::optional<double> radius, double max_memory_gb) {
  RegistrationOptions options;
  options.voxel_size = voxel_size;
  options.radius = radius;
  options.max_memory_gb = max_memory_gb;
  return options;
}

PreparedPair prepared(const RegistrationOptions& options) {
  return prepare_pair(box(30000, 1), box(30000, 2), options);
}

std::string refusal(const RegistrationOptions& options) {
  try {
    prepared(options);
  } catch (const TooMuchMemory& error) {
    return error.what();
  }
  return {};
}

// The value that a message names after a word.
std::optional<double> advised(const std::string& message, const std::string& name) {
  std::smatch found;
  if (!std::regex_search(message, found, std::regex(name + " ([0-9.e+-]+)"))) return std::nullopt;
  return std::stod(found[1]);
}

TEST(Memory, WhatIsRefusedFitsWithTheAdvisedLengths) {
  for (const RegistrationOptions& refused :
       {with_lengths(0.01, 0.2, 0.06), with_lengths(0.002, 0.15, 0.04), with_lengths(0.001, std::nullopt, 0.03),
        with_lengths(std::nullopt, 0.05, 0.012), with_lengths(std::nullopt, std::nullopt, 0.005)}) {
    const std::string message = refusal(refused);
    ASSERT_NE(message, "");
    const std::optional<double> voxel_size = advised(message, "use voxel_size"), radius = advised(message, "or radius");
    ASSERT_TRUE(voxel_size) << message;
    EXPECT_EQ(radius.has_value(), refused.voxel_size.has_value()) << message;
    RegistrationOptions enough = refused;
    enough.voxel_size = voxel_size;
    EXPECT_EQ(refusal(enough), "") << message;
    if (!radius) continue;
    enough = refused;
    enough.radius = radius;
    EXPECT_EQ(refusal(enough), "") << message;
  }
}

TEST(Memory, TheBoundAloneDecides) {
  const RegistrationOptions usual = with_lengths(0.01, 0.2, 0.06);
  EXPECT_THAT(refusal(usual), ::testing::HasSubstr("0.06 GB"));
  EXPECT_EQ(refusal(with_lengths(0.01, 0.2, 1.0)), "");
  EXPECT_EQ(refusal(with_lengths(0.01, 0.2, kInfinity)), "");
  EXPECT_EQ(refusal(with_lengths(0.01, 0.2, 1.0)), refusal(with_lengths(0.01, 0.2, 2.0)));
}

// The lists of a ball this large would be refused while they are made.
TEST(Memory, BallsThatWouldBeRefusedLaterAreRefusedBefore) {
  const std::string message = refusal(with_lengths(0.01, 1.5, kInfinity));
  EXPECT_THAT(message, ::testing::HasSubstr("512 points in a ball are allowed"));
  EXPECT_LT(*advised(message, "or radius"), 1.5);
}

// Then no length helps, and the message does not name one.
TEST(Memory, MorePointsThanFitAreSaidToBeSo) {
  const std::string message = refusal(with_lengths(0.01, 0.1, 1e-4));
  EXPECT_THAT(message, ::testing::EndsWith("use larger lengths, fewer points, or a larger max_memory_gb"));
}

TEST(Memory, TheRefusalIsTheSameForAnyNumberOfThreads) {
  RegistrationOptions options = with_lengths(0.01, 0.2, 0.06);
  options.num_threads = 1;
  const std::string alone = refusal(options);
  options.num_threads = 4;
  EXPECT_EQ(refusal(options), alone);
}

TEST(Memory, OfDepthImagesAndKnownDirectionsIsNotAsked) {
  Scan scan = box(30000, 1);
  scan.cloud.directions.assign(scan.cloud.size(), Vec3f::UnitX());
  scan.cloud.structures.assign(scan.cloud.size(), Structure::Planar);
  EXPECT_NO_THROW(prepare_pair(scan, scan, with_lengths(0.01, 0.2, 1e-3)));
}

TEST(Memory, TheMessageTakesTheNamesOfTheCommand) {
  const TooMuchMemory error("much", {0.5, std::nullopt});
  EXPECT_STREQ(error.what(), "much: use voxel_size 0.5, or a larger max_memory_gb");
  EXPECT_EQ(error.message({"--voxel-size", "--radius", "--max-memory"}),
            "much: use --voxel-size 0.5, or a larger --max-memory");
}

}  // namespace
}  // namespace augicp
