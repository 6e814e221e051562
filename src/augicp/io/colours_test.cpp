// SPDX-License-Identifier: MIT
#include "augicp/io/colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "augicp/io/cloud_from_points.h"
#include "augicp/io/read_cloud.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

CloudFile parsed(const std::string& text) { return parse_cloud({"a.ply", text}, {.keep_fields = true}); }

std::string ply(const std::string& type, const std::string& rows) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  for (const char* name : {"red", "green", "blue"}) text += "property " + type + " " + name + "\n";
  return text + "end_header\n" + rows;
}

const std::vector<Colour> kExpected{{255, 0, 51}, {0, 102, 255}};

TEST(Colours, EachUnitOfAFileGivesTheSameBytes) {
  for (const auto& [type, rows] :
       std::vector<std::pair<std::string, std::string>>{{"uchar", "0 0 0 255 0 51\n1 1 1 0 102 255\n"},
                                                        {"ushort", "0 0 0 65535 0 13107\n1 1 1 0 26214 65535\n"},
                                                        {"ushort", "0 0 0 255 0 51\n1 1 1 0 102 255\n"},
                                                        {"float", "0 0 0 1 0 0.2\n1 1 1 0 0.4 1\n"},
                                                        {"double", "0 0 0 255 0 51\n1 1 1 -3 102 255\n"}})
    EXPECT_EQ(colours_of(parsed(ply(type, rows))), kExpected) << type << "\n" << rows;
}

TEST(Colours, DarkBytesAreNoShares) {
  EXPECT_THAT(colours_of(parsed(ply("uchar", "0 0 0 1 0 1\n1 1 1 0 1 1\n"))),
              ElementsAre(Colour{1, 0, 1}, Colour{0, 1, 1}));
}

TEST(Colours, AFileWithoutThemHasNone) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
      "red\nend_header\n0 0 0 7\n";
  EXPECT_THAT(colours_of(parsed(text)), IsEmpty());
  EXPECT_THAT(colours_of(parse_cloud({"a.ply", ply("uchar", "0 0 0 1 0 1\n1 1 1 0 1 1\n")})), IsEmpty());
}

// From memory to a file and back, in each format; a dropped point takes its colour along.
TEST(Colours, OfPointsInMemorySurviveEachFormat) {
  const std::vector<Vec3d> points{{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {1, 2, 3}};
  const std::vector<Colour> colours{kExpected[0], {9, 9, 9}, kExpected[1]};
  PointSource source;
  source.count = points.size();
  source.position = [&](std::size_t i) { return points[i]; };
  source.colour = [&](std::size_t i) { return colours[i]; };
  const CloudFile file = cloud_from_points(source);
  EXPECT_EQ(colours_of(file), kExpected);
  const testing::TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.pcd", "a.las"}) {
    write_cloud(folder.path() / name, file);
    EXPECT_EQ(colours_of(read_cloud(folder.path() / name, {.keep_fields = true})), kExpected) << name;
  }
}

}  // namespace
}  // namespace augicp
