// SPDX-License-Identifier: MIT
#include "augicp/io/read_xyz.h"

#include "augicp/io/read_cloud.h"
#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using testing::expect_refused;
using testing::parse;
using testing::with;
using testing::with_all;
using Points = std::vector<Vec3f>;

constexpr const char* kXyzText = "1 2 3\n4 5 6\n7 8 9.25\n";
const Points kXyzPoints{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.25}};

// robustness 5
TEST(ReadXyz, SeparatorsLineEndsAndCommentsDoNotMatter) {
  const std::string text = kXyzText;
  const std::string comment = std::string("# ").append(1 << 20, 'c').append("\n");
  for (const std::string& bytes :
       {text, with_all(text, " ", "\t"), with_all(text, " ", ","), with_all(text, " ", " , "), with_all(text, " ", ";"),
        with_all(text, "\n", "\r\n"), with_all(text, "\n", "\r"), with_all(text, "\n", " 17 red\n\n"), comment + text,
        with(text, "4", "  # four\n4"), std::string("\xef\xbb\xbf").append(text)}) {
    const CloudFile file = parse("a.xyz", bytes);
    EXPECT_EQ(file.cloud.points, kXyzPoints) << bytes.substr(0, 100);
    EXPECT_THAT(file.report.warnings, ::testing::IsEmpty());
    EXPECT_EQ(file.report.num_declared, 3u);
  }
}

TEST(ReadXyz, PointsThatAreLeftOutAreCounted) {
  const CloudFile file = parse("a.xyz", "1 2 3\nnan 2 3\n4 5 6\n7 8 9.25\n1 inf 3\n");
  EXPECT_EQ(file.cloud.points, kXyzPoints);
  EXPECT_THAT(file.report.warnings, ::testing::ElementsAre(::testing::HasSubstr("5 points read, 2 left out")));
}

TEST(ReadXyz, AHeaderNamesTheColumns) {
  const CloudFile file = parse("a.csv", "Intensity,Z,Y,X,nx,ny,nz\n9,3,2,1,0,0,2\n9,6,5,4,0,0,0\n9,9.25,8,7,1,0,0\n");
  EXPECT_EQ(file.cloud.points, kXyzPoints);
  EXPECT_EQ(file.cloud.directions, (Points{{0, 0, 1}, {0, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(parse("a.txt", std::string("//X Y Z\n") + kXyzText).cloud.points, kXyzPoints);
  EXPECT_EQ(parse("a.csv", std::string("x , y , z\n") + with_all(kXyzText, " ", " , ")).cloud.points, kXyzPoints);
}

TEST(ReadXyz, ACommentMayNameTheColumns) {
  EXPECT_EQ(parse("a.txt", "# r g b x y z\n9 9 9 1 2 3\n0 0 0 4 5 6\n7 7 7 7 8 9.25\n").cloud.points, kXyzPoints);
  EXPECT_EQ(parse("a.txt", "# a survey\n#Z;Y;X\n3;2;1\n6;5;4\n9.25;8;7\n").cloud.points, kXyzPoints);
  EXPECT_EQ(parse("a.csv", "\"z\",\"y\",\"x\"\n3,2,1\n6,5,4\n9.25,8,7\n").cloud.points, kXyzPoints);
  // Prose, and names that say what holds anyhow.
  for (const char* comment : {"# x y z\n", "# positions x y\n", "# x y z of every point\n", "# x y z r g b\n"})
    EXPECT_EQ(parse("a.xyz", comment + std::string(kXyzText)).cloud.points, kXyzPoints) << comment;
  expect_refused("a.txt", std::string("# r g b x y z\n") + kXyzText, "names 6 columns, the first point has 3 numbers");
}

TEST(ReadXyz, AHeaderMayBeFollowedByTheCount) {
  EXPECT_EQ(parse("a.txt", std::string("//X Y Z\n3\n") + kXyzText).cloud.points, kXyzPoints);
  expect_refused("a.txt", std::string("//X Y Z\n4\n") + kXyzText, "expected 4 points");
}

// robustness 3
TEST(ReadXyz, ASingleNumberFirstIsTheCount) {
  EXPECT_EQ(parse("a.pts", std::string("3\n") + kXyzText).cloud.points, kXyzPoints);
  const CloudFile fewer = parse("a.pts", std::string("2\n") + kXyzText);
  EXPECT_EQ(fewer.report.num_declared, 2u);
  EXPECT_THAT(fewer.report.warnings, ::testing::ElementsAre("lines after the declared points were not read"));
  expect_refused("a.pts", std::string("4\n") + kXyzText, "expected 4 points");
}

// robustness 1. Without a count, a file cut between lines is a shorter file.
TEST(ReadXyz, CutsWithinALineAreSeen) {
  testing::expect_cuts_are_seen("a.pts", std::string("3\n") + kXyzText);
  const std::string text = kXyzText;
  for (std::size_t length = 1; length < text.size(); ++length) {
    if (text[length - 1] == '\n') continue;
    const std::string cut = text.substr(0, length);
    if (!testing::refusal("a.xyz", cut).empty()) continue;
    EXPECT_EQ(parse("a.xyz", cut).report.warnings.size(), 1u) << length;
  }
}

// robustness 2
TEST(ReadXyz, CountsThatCannotBeAreErrors) {
  for (const char* count :
       {"0", "-1", "30", "2147483647", "4294967296", "9223372036854775808", "1000000000", "nan", "3.0"})
    expect_refused("a.pts", std::string(count) + "\n" + kXyzText, "a.pts: ");
  EXPECT_THAT(testing::refusal("a.xyz", kXyzText, {.max_points = 2}),
              ::testing::HasSubstr("expected at most 2 points"));
}

Vec3d first_position(const CloudFile& read) { return read.cloud.origin + read.cloud.points.at(0).cast<double>(); }

TEST(ReadXyz, QuotedFieldsMayContainSeparators) {
  for (const char* bytes :
       {"name,x,y,z\n\"a, 8, 9, 0\",1,2.5,3\n", "\"x\",\"y\",\"z\"\n\"1\",\"2.5\",\"3\"\n", "\"1\",\"2.5\",\"3\"\n"}) {
    const CloudFile read = parse_cloud({"a.csv", bytes}, {});
    EXPECT_EQ(first_position(read), Vec3d(1, 2.5, 3)) << bytes;
  }
}

TEST(ReadXyz, DecimalCommasAreReadBetweenSemicolonsAndSaid) {
  ReadOptions options;
  options.keep_fields = true;
  for (const char* bytes : {"x;y;z;t\n1;2,5;3;0,25\n", "1;2,5;3;0,25\n"}) {
    const CloudFile read = parse_cloud({"a.csv", bytes}, options);
    EXPECT_EQ(first_position(read), Vec3d(1, 2.5, 3)) << bytes;
    ASSERT_EQ(read.fields.fields.size(), 1u);
    EXPECT_EQ(read.fields.fields[0].at(0), 0.25);
    EXPECT_THAT(read.report.warnings, ::testing::ElementsAre("commas in numbers were read as decimal points"));
  }
  EXPECT_TRUE(parse_cloud({"a.csv", "1;2.5;3\n"}, {}).report.warnings.empty());
}

// robustness 4, 6
TEST(ReadXyz, LinesThatAreNoPointAreErrors) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "holds no points"},
      {"# nothing\n\n", "holds no points"},
      {"x y z\n", "holds no points"},
      {"x y w\n1 2 3\n", "expected a column 'z', found none"},
      {"x y z x\n1 2 3 4\n", "expected one column 'x', found a second"},
      {"1 2\n", "line 1: expected at least 3 values, found 2: '1 2'"},
      {"1 2 3\n4 five 6\n", "line 2: expected a number, found 'five'"},
      {"1 2 3\n\n#\n4 5\n", "line 4: expected at least 3 values"},
      {"1,5 2,5 3,5\n", "line 1: expected a number, found '5 2'"},
      {"1,5;2;3\n1.5;2;3\n", "line 2: expected either decimal commas or decimal points, found both"},
      {"1.234,5;2;3\n", "a column 'x', found none"},
      {"1;2;3\n1,234,567;2;3\n", "line 2: expected a number, found '1,234,567'"},
      {"name,x,y,z\na,1,2,3\n\"a, 8, 9, 0,1,2,3\n", "line 3: expected at least 4 values, found 1"},
      {"1,,3\n", "line 1: expected a number, found ''"},
      {"nan nan nan\ninf 0 0\n1e308 0 0\n", "none of its 3 points is finite and within 1e+18 m"},
      {"1e30 0 0\n0 -1e19 0\n", "none of its 2 points is finite and within 1e+18 m"},
      {std::string("1 2 3\n\0\0\0", 9), "byte 6: expected text, found a zero byte"}};
  for (const auto& [bytes, message] : cases) expect_refused("a.xyz", bytes, message);
}

// robustness 15
TEST(ReadXyz, FarCoordinatesLoseNothing) { testing::expect_far_coordinates_survive("a.xyz", testing::rows_of_three); }

// MATLAB's comments, C++'s, spreadsheets' line of the separator.
TEST(ReadXyz, CommentsAndTheLineOfTheSeparatorAreNoPoints) {
  for (const char* bytes : {"% x y z\n1 2 3\n", "// made by a scanner\n1 2 3\n// end\n", "sep=;\nx;y;z\n1;2;3\n",
                            "sep=\t\n1 2 3\n", "SEP=,\r\n1,2,3\r\n"}) {
    const CloudFile read = parse_cloud({"a.csv", bytes}, {});
    EXPECT_EQ(first_position(read), Vec3d(1, 2, 3)) << bytes;
    EXPECT_EQ(read.cloud.size(), 1u) << bytes;
    EXPECT_TRUE(read.report.warnings.empty()) << bytes;
  }
}

// ParaView, VeloView, surveys, spreadsheets.
TEST(ReadXyz, CoordinatesUnderOtherNamesAreFound) {
  for (const char* names : {"t,Points:0,Points:1,Points:2", "t,\"Points_0\",\"Points_1\",\"Points_2\"",
                            "t,Points_m_XYZ:0,Points_m_XYZ:1,Points_m_XYZ:2", "t,Easting,Northing,Elevation",
                            "t,X (m),Y (m),Z (m)", "t,x[m],y[m],z[m]"})
    EXPECT_EQ(first_position(parse_cloud({"a.csv", std::string(names) + "\n9,1,2,3\n"}, {})), Vec3d(1, 2, 3)) << names;
  EXPECT_EQ(first_position(parse_cloud({"a.csv", "easting,northing,elevation,x,y,z\n7,8,9,1,2,3\n"}, {})),
            Vec3d(1, 2, 3));
}

TEST(ReadXyz, ARefusalNamesTheColumnsThatThereAre) {
  expect_refused("a.csv", "range,azimuth,lidar y\n1,2,3\n",
                 "expected a column 'x', found none among 'range' 'azimuth' 'lidar y'");
}

TEST(ReadXyz, ALineOfAnotherLengthIsSaidOnce) {
  const auto warnings = [](const char* bytes) { return parse_cloud({"a.xyz", bytes}, {}).report.warnings; };
  EXPECT_THAT(warnings("1 2 3\n1 2 3 4\n5 6 7 8\n"),
              ::testing::ElementsAre("line 2 has 4 values, the first point has 3"));
  EXPECT_THAT(warnings("x y z t\n1 2 3 4\n1 2 3\n"),
              ::testing::ElementsAre("line 3 has 3 values, the first point has 4"));
  EXPECT_THAT(warnings("1 2 3 4\n5 6 7 8\n"), ::testing::IsEmpty());
}

std::vector<std::string> names_of_fields(const char* file, const std::string& bytes) {
  ReadOptions options;
  options.keep_fields = true;
  std::vector<std::string> names;
  for (const PointField& field : parse_cloud({file, bytes}, options).fields.fields) names.push_back(field.name);
  return names;
}

// As viewers look for them.
TEST(ReadXyz, ColoursHaveTheNamesOfPly) {
  const std::vector<std::string> colours{"red", "green", "blue"};
  EXPECT_EQ(names_of_fields("a.txt", "//X Y Z R G B\n1\n1 2 3 4 5 6\n"), colours);
  EXPECT_EQ(names_of_fields("a.txt", "# r g b x y z\n4 5 6 1 2 3\n"), colours);
  EXPECT_EQ(names_of_fields("a.xyzrgb", "1 2 3 .4 .5 .6\n"), colours);
  EXPECT_EQ(names_of_fields("a.pts", "1\n1 2 3 4 5 6\n"), colours);
  EXPECT_EQ(names_of_fields("a.csv", "x,y,z,r,b\n1,2,3,4,5\n"), (std::vector<std::string>{"r", "b"}));
}

TEST(ReadXyz, PointsOfAPtsFileHaveIntensityAndColour) {
  EXPECT_EQ(names_of_fields("a.pts", "1\n1 2 3 -1000 4 5 6\n"),
            (std::vector<std::string>{"intensity", "red", "green", "blue"}));
  EXPECT_EQ(parse_cloud({"a.pts", "1\n1 2 3 -1000 4 5 6\n"}, {}).cloud.intensities, std::vector<float>{-1000});
  EXPECT_EQ(names_of_fields("a.xyz", "1\n1 2 3 4 5 6\n"),
            (std::vector<std::string>{"column_4", "column_5", "column_6"}));
}

TEST(ReadXyz, XyznHasNormals) {
  const CloudFile read = parse_cloud({"a.xyzn", "1 2 3 0 0 2\n"}, {});
  EXPECT_TRUE(read.report.has_normals);
  EXPECT_EQ(read.cloud.directions, std::vector<Vec3f>{Vec3f(0, 0, 1)});
}

// Whatever other comments stand around it.
TEST(ReadXyz, AnyCommentBeforeTheFirstPointMayNameTheColumns) {
  const Cloud cloud =
      testing::parse("a.txt", "# scan 7\n# r g b x y z\n# made by a scanner\n9 9 9 1 2 3\n9 9 9 4 5 6\n").cloud;
  EXPECT_EQ(cloud.points, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}}));
}

}  // namespace
}  // namespace augicp
