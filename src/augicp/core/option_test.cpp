// SPDX-License-Identifier: MIT
#include "augicp/core/option.h"

#include <gmock/gmock.h>

namespace augicp {
namespace {

TEST(Option, AnglesHaveDegreesOutside) {
  const OptionText angle{"max_angle", Unit::Radians, "Method", "Larger ones are dropped"};
  EXPECT_EQ(outer_name(angle), "max_angle_deg");
  EXPECT_EQ(flag_name(angle), "max-angle-deg");
  EXPECT_EQ(described(angle, angle.unit), "Larger ones are dropped, radians");
  EXPECT_EQ(described(angle, outer_unit(angle.unit)), "Larger ones are dropped, degrees");
}

TEST(Option, FlagsLackTheSuffixOfTheUnit) {
  EXPECT_EQ(flag_name({"time_offset_s", Unit::Seconds, "", ""}), "time-offset");
  EXPECT_EQ(flag_name({"kernel_chi2", Unit::Chi2, "", ""}), "kernel");
  EXPECT_EQ(flag_name({"max_memory_gb", Unit::Gigabytes, "", ""}), "max-memory");
  EXPECT_EQ(flag_name({"guess_s", Unit::None, "", ""}), "guess-s");
  EXPECT_EQ(flag_name({"radius", Unit::Metres, "", ""}), "radius");
  EXPECT_EQ(outer_name({"time_offset_s", Unit::Seconds, "", ""}), "time_offset_s");
}

TEST(Option, ReservedWordsLoseTheirUnderscoreOutside) {
  const OptionText reserved{"global_", Unit::None, "", ""};
  EXPECT_EQ(flag_name(reserved), "global");
  EXPECT_EQ(outer_name(reserved), "global");
}

TEST(Option, TheSourceOfWhatIsNotSetIsNamed) {
  EXPECT_EQ(described({"radius", Unit::Metres, "", "Of the ball", "derived"}, Unit::Metres),
            "Of the ball, metres (default: derived)");
  EXPECT_EQ(described({"method", Unit::None, "", "Which one"}, Unit::None), "Which one");
}

TEST(Option, InnerUndoesOuter) {
  for (const Unit unit : {Unit::None, Unit::Metres, Unit::Radians, Unit::Seconds, Unit::Chi2})
    for (const double value : {0.0, 1e-9, -0.3, 1.0471975511965976, 400.0})
      EXPECT_NEAR(inner_value(unit, outer_value(unit, value)), value, 1e-15 * std::abs(value)) << name_of(unit);
  EXPECT_DOUBLE_EQ(outer_value(Unit::Radians, std::numbers::pi), 180.0);
}

}  // namespace
}  // namespace augicp
