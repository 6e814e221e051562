// SPDX-License-Identifier: MIT
#include "augicp/io/reference_pairs_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace augicp {
namespace {

using ::testing::HasSubstr;

std::string pairs_fault(const std::string& text) {
  try {
    parse_reference_pairs({"pairs.txt", text});
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(ReferencePairs, MoreThanNineValuesAreFine) {
  const auto pairs =
      parse_reference_pairs({"pairs.txt", "# i j ...\n0 10 1 2 3 0 0 0 1 0.186 nan\n\n10 20 4 5 6 0 0 1 0\n"});
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[1].first, 10u);
  EXPECT_EQ(pairs[1].second, 20u);
  EXPECT_TRUE((pairs[1].first_from_second * Vec3d(1.0, 0.0, 0.0)).isApprox(Vec3d(3.0, 5.0, 6.0), 1e-12));
}

TEST(ReferencePairs, FaultsNameTheLine) {
  EXPECT_THAT(pairs_fault("0 1 1 2 3 0 0 0 1\n0 1 1 2 3 0 0 0\n"), HasSubstr("line 2: expected i j tx"));
  EXPECT_THAT(pairs_fault("0 1.5 1 2 3 0 0 0 1\n"), HasSubstr("line 1: expected the place"));
  EXPECT_THAT(pairs_fault("-1 1 1 2 3 0 0 0 1\n"), HasSubstr("line 1: expected the place"));
  EXPECT_THAT(pairs_fault("5 5 1 2 3 0 0 0 1\n"), HasSubstr("line 1: expected i < j"));
  EXPECT_THAT(pairs_fault("0 1 1 2 3 0 0 0 2\n"), HasSubstr("length 1, found length 2"));
  EXPECT_THAT(pairs_fault(""), HasSubstr("found none"));
}

}  // namespace
}  // namespace augicp
