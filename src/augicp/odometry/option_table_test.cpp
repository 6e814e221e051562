// SPDX-License-Identifier: MIT
#include "augicp/odometry/option_table.h"

#include "augicp/testing/option_tables.h"

namespace augicp {
namespace {

TEST(OptionTable, TextsAreSound) { expect_sound_texts(OdometryOptions{}); }

TEST(OptionTable, EachLineHasAFieldOfItsOwn) { expect_fields_of_their_own<OdometryOptions>(); }

}  // namespace
}  // namespace augicp
