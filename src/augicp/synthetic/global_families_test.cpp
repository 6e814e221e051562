// SPDX-License-Identifier: MIT
#include "augicp/synthetic/global_families.h"

#include <gtest/gtest.h>

#include <set>

#include "augicp/experiment/fragments.h"

namespace augicp::synthetic {
namespace {

TEST(GlobalFamilies, AreDrawnFromTheirSeedAlone) {
  std::set<std::string> names;
  for (const GlobalFamily& family : global_families()) {
    const DrawnPair first = family.draw(5), again = family.draw(5), other = family.draw(6);
    EXPECT_EQ(first.source.points, again.source.points) << family.name;
    EXPECT_EQ(first.target.points, again.target.points) << family.name;
    EXPECT_NE(first.source.points, other.source.points) << family.name;
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
  }
}

TEST(GlobalFamilies, TheTruthIsTrueAndWhatIsApartHasNone) {
  for (const GlobalFamily& family : global_families()) {
    const DrawnPair pair = family.draw(3);
    EXPECT_EQ(pair.target_from_source.has_value(), !family.name.ends_with("apart")) << family.name;
    if (!pair.target_from_source) continue;
    const double distance = 0.1 * family.length_scale;
    const Rigid3 elsewhere{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3d(0.6, 0.0, 0.8))),
                           10.0 * distance * Vec3d(1.0, 1.0, 1.0)};
    const double overlap = overlap_of(pair.source, pair.target, *pair.target_from_source, distance);
    EXPECT_GT(overlap, 0.3) << family.name;
    EXPECT_GT(overlap, overlap_of(pair.source, pair.target, elsewhere, distance)) << family.name;
  }
}

}  // namespace
}  // namespace augicp::synthetic
