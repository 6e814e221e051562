// SPDX-License-Identifier: MIT
#include "augicp/eval/option_table.h"

#include "augicp/testing/option_tables.h"

namespace augicp {
namespace {

TEST(OptionTable, TextsAreSound) { expect_sound_texts(EvaluationOptions{}); }

TEST(OptionTable, EachLineHasAFieldOfItsOwn) { expect_fields_of_their_own<EvaluationOptions>(); }

}  // namespace
}  // namespace augicp
