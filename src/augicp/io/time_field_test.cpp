// SPDX-License-Identifier: MIT
// The times of points, in every format that can have them.
#include "augicp/io/time_field.h"

#include <array>
#include <utility>

#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;

const ReadOptions kKeepTimes{.keep_fields = true};

// The second of four points is not finite.
constexpr const char* kRows = "1 2 3 10 7\nnan 2 3 20 8\n4 5 6 30 9\n7 5 6 40 1\n";

std::string ply(const std::string& first, const std::string& second) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "property uint " +
         first + "\nproperty double " + second + "\nend_header\n" + kRows;
}

std::string pcd(const std::string& first, const std::string& second, const std::string& size = "WIDTH 4\nHEIGHT 1") {
  return "VERSION .7\nFIELDS x y z " + first + " " + second + "\nSIZE 4 4 4 4 8\nTYPE F F F U F\nCOUNT 1 1 1 1 1\n" +
         size + "\nPOINTS 4\nDATA ascii\n" + kRows;
}

std::string flat_pcd(const std::string& first, const std::string& second) { return pcd(first, second); }

std::string organised_pcd(const std::string& first, const std::string& second) {
  return pcd(first, second, "WIDTH 2\nHEIGHT 2");
}

using Writer = std::string (*)(const std::string&, const std::string&);
constexpr std::array<std::pair<const char*, Writer>, 3> kFormats{
    {{"a.ply", ply}, {"a.pcd", flat_pcd}, {"b.pcd", organised_pcd}}};

TEST(TimeField, KnownNamesAreTakenInTheirOrderInEitherCase) {
  for (const auto& [name, written] : kFormats) {
    const CloudFile file = testing::parse(name, written("timestamp", "T"), kKeepTimes);
    ASSERT_TRUE(find_time_field(file, "")) << name;
    EXPECT_THAT(values_of_points(file, *find_time_field(file, "")), ElementsAre(7.0, 9.0, 1.0)) << name;
    EXPECT_FALSE(find_time_field(testing::parse(name, written("ring", "stamp"), kKeepTimes), "")) << name;
  }
}

TEST(TimeField, AnyFieldCanBeNamed) {
  for (const auto& [name, written] : kFormats) {
    const CloudFile file = testing::parse(name, written("Stamp", "t"), kKeepTimes);
    ASSERT_TRUE(find_time_field(file, "sTAMP")) << name;
    EXPECT_THAT(values_of_points(file, *find_time_field(file, "sTAMP")), ElementsAre(10.0, 30.0, 40.0)) << name;
    EXPECT_FALSE(find_time_field(file, "time")) << name;
  }
}

}  // namespace
}  // namespace augicp
