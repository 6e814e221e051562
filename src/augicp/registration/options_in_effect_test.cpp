// SPDX-License-Identifier: MIT
#include "augicp/registration/options_in_effect.h"

#include <gtest/gtest.h>

#include <set>

#include "augicp/registration/registration.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

const Lengths kLengths{4.0, 0.2, 0.07, 0.5};

TEST(OptionsInEffect, LengthsAreThoseOfTheResult) {
  const RegistrationOptions found = options_in_effect({}, kLengths, true);
  EXPECT_EQ(found.radius, kLengths.radius);
  EXPECT_EQ(found.voxel_size, kLengths.voxel_size);
  EXPECT_EQ(found.max_distance, kLengths.max_distance);
  EXPECT_TRUE(found.search && found.final_pass && found.coarse_to_fine && found.rolling_shutter);
  EXPECT_FALSE(options_in_effect({}, Lengths{}, true).radius) << "nothing was derived from inputs without extent";
}

TEST(OptionsInEffect, ThePaperHasTheLoopAlone) {
  RegistrationOptions paper;
  paper.preset = Preset::Paper;
  const RegistrationOptions found = options_in_effect(paper, kLengths, true);
  EXPECT_FALSE(found.search || found.final_pass || found.coarse_to_fine || found.rolling_shutter);
}

// What is off leaves no trace among the stages.
TEST(OptionsInEffect, WhatIsOffIsNotDone) {
  Cloud corner = testing::random_points(1200, 1.0, 3);
  for (std::size_t i = 0; i < corner.size(); ++i) {
    corner.points[i][i % 3] = -1.0f;
    corner.points[i] = corner.points[i].cwiseProduct(Vec3f(1.0f, 0.8f, 0.6f));  // equal sides would be ambiguous
  }
  std::vector<RegistrationOptions> all(4);
  all[1].preset = Preset::Paper;
  all[2].radius = 0.3;
  all[3].covariance = false;
  for (RegistrationOptions& options : all) {
    std::set<Stage> stages;
    options.on_stage = [&](const StageReport& report) { stages.insert(report.stage); };
    const Registration found = register_scans(scan_of(corner), scan_of(corner), {}, options);
    const RegistrationOptions in_effect = options_in_effect(options, found.prepared.lengths, true);
    EXPECT_EQ(in_effect.final_pass, stages.contains(Stage::FinalPass)) << (&options - all.data());
    EXPECT_FALSE(!in_effect.search && (stages.contains(Stage::Search) || stages.contains(Stage::Rivals)));
  }
}

TEST(OptionsInEffect, TheFinalPassNeedsCloudsDerivedLengthsAndACovariance) {
  EXPECT_FALSE(options_in_effect({}, kLengths, false).final_pass);
  for (const auto change : {+[](RegistrationOptions& options) { options.radius = 0.1; },
                            +[](RegistrationOptions& options) { options.voxel_size = 0.1; },
                            +[](RegistrationOptions& options) { options.covariance = false; },
                            +[](RegistrationOptions& options) { options.final_pass = false; }}) {
    RegistrationOptions options;
    change(options);
    EXPECT_FALSE(options_in_effect(options, kLengths, true).final_pass);
  }
}

}  // namespace
}  // namespace augicp
