// SPDX-License-Identifier: MIT
#include "augicp/registration/stage.h"

#include <gmock/gmock.h>

#include <set>
#include <stdexcept>

#include "augicp/registration/registration.h"
#include "augicp/testing/random_clouds.h"

namespace augicp {
namespace {

std::vector<StageReport> reports_of(const Scan& source, const Scan& target, RegistrationOptions options) {
  std::vector<StageReport> reports;
  options.on_stage = [&](const StageReport& report) { reports.push_back(report); };
  register_scans(source, target, {}, options);
  return reports;
}

std::set<Stage> stages_of(const std::vector<StageReport>& reports) {
  std::set<Stage> stages;
  for (const StageReport& report : reports) stages.insert(report.stage);
  return stages;
}

// A corner, and noise that fits nowhere.
Scan corner() {
  Cloud cloud = testing::random_points(1200, 1.0, 3);
  for (std::size_t i = 0; i < cloud.size(); ++i) cloud.points[i][i % 3] = -1.0f;
  return scan_of(cloud);
}
Scan nothing_alike() { return scan_of(testing::random_points(1200, 1.0, 4)); }

TEST(Stage, EveryBeginningHasItsEnd) {
  for (const Scan& source : {corner(), nothing_alike()}) {
    std::optional<StageReport> open;
    for (const StageReport& report : reports_of(source, corner(), {})) {
      EXPECT_LE(report.done, report.total);
      if (!open) {
        EXPECT_LT(report.done, report.total);
        open = report;
        continue;
      }
      EXPECT_EQ(report.stage, open->stage);
      EXPECT_EQ(report.done, open->done + 1);
      open.reset();
    }
    EXPECT_FALSE(open);
  }
}

TEST(Stage, AGuessThatConvincesNeedsNoSearch) {
  const auto stages = stages_of(reports_of(corner(), corner(), {}));
  for (const Stage stage : {Stage::Surfaces, Stage::Indexing, Stage::Aligning, Stage::Verdict, Stage::Rivals})
    EXPECT_EQ(stages.count(stage), 1u) << name_of(stage);
  EXPECT_EQ(stages.count(Stage::Search) + stages.count(Stage::Descriptors), 0u);
}

TEST(Stage, WhatDoesNotConvinceIsSearched) {
  const auto stages = stages_of(reports_of(nothing_alike(), corner(), {}));
  EXPECT_EQ(stages.count(Stage::Search), 1u);
  EXPECT_EQ(stages.count(Stage::Descriptors), 1u);
  RegistrationOptions options;
  options.search = false;
  EXPECT_EQ(stages_of(reports_of(nothing_alike(), corner(), options)).count(Stage::Search), 0u);
}

TEST(Stage, WhatTheListenerThrowsReachesTheCaller) {
  for (const Stage at : {Stage::Surfaces, Stage::Aligning, Stage::Verdict}) {
    RegistrationOptions options;
    options.on_stage = [&](const StageReport& report) {
      if (report.stage == at) throw std::domain_error("enough");
    };
    EXPECT_THROW(register_scans(corner(), corner(), {}, options), std::domain_error) << name_of(at);
  }
}

TEST(Stage, ListeningChangesNothing) {
  RegistrationOptions options;
  const Registration alone = register_scans(nothing_alike(), corner(), {}, options);
  options.on_stage = [](const StageReport&) {};
  const Registration heard = register_scans(nothing_alike(), corner(), {}, options);
  EXPECT_EQ(heard.result.target_from_source.matrix(), alone.result.target_from_source.matrix());
  EXPECT_EQ(heard.result.status, alone.result.status);
}

}  // namespace
}  // namespace augicp
