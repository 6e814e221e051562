// SPDX-License-Identifier: MIT
#include "augicp/registration/option_table.h"

#include "augicp/testing/option_tables.h"

namespace augicp {
namespace {

TEST(OptionTable, TextsAreSound) { expect_sound_texts(RegistrationOptions{}); }

TEST(OptionTable, EachLineHasAFieldOfItsOwn) { expect_fields_of_their_own<RegistrationOptions>(); }

}  // namespace
}  // namespace augicp
