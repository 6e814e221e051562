// SPDX-License-Identifier: MIT
#include "augicp/io/read_pcd.h"

#include <lzf.h>

#include <limits>
#include <tuple>

#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using testing::expect_refused;
using testing::packed;
using testing::parse;
using testing::places;
using testing::with;
using testing::with_all;
using Points = std::vector<Vec3f>;

constexpr const char* kPcdText =
    "# .PCD v0.7 - Point Cloud Data file format\n"
    "VERSION 0.7\n"
    "FIELDS x y z _ hue\n"
    "SIZE 4 4 4 1 2\n"
    "TYPE F F F U I\n"
    "COUNT 1 1 1 3 2\n"
    "WIDTH 2\n"
    "HEIGHT 2\n"
    "VIEWPOINT 0 0 0 1 0 0 0\n"
    "POINTS 4\n"
    "DATA ascii\n"
    "1 2 3 0 0 0 -7 8\n"
    "nan nan nan 0 0 0 -7 8\n"
    "4 5 6 0 0 0 -7 8\n"
    "7 8 9.25 0 0 0 -7 8\n";
const Points kPcdPoints{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.25}};
constexpr float kNanField = std::numeric_limits<float>::quiet_NaN();

std::string header(std::string_view encoding) {
  return with(std::string(kPcdText).substr(0, std::string_view(kPcdText).find("1 2 3 0")), "ascii", encoding);
}

std::string binary_pcd() {
  std::string bytes = header("binary");
  for (const auto& point :
       std::vector<std::vector<float>>{{1, 2, 3}, {kNanField, kNanField, kNanField}, {4, 5, 6}, {7, 8, 9.25}})
    bytes += packed(point) + std::string(3, '\0') + packed<std::int16_t>({-7, 8});
  return bytes;
}

std::string compressed(const std::string& bytes) {
  std::string packed_bytes(2 * bytes.size() + 64, '\0');
  packed_bytes.resize(lzf_compress(bytes.data(), static_cast<unsigned>(bytes.size()), packed_bytes.data(),
                                   static_cast<unsigned>(packed_bytes.size())));
  return packed<std::uint32_t>(
             {static_cast<std::uint32_t>(packed_bytes.size()), static_cast<std::uint32_t>(bytes.size())}) +
         packed_bytes;
}

// Field after field, without the padding.
std::string compressed_file() {
  return header("binary_compressed") +
         compressed(packed<float>({1, kNanField, 4, 7, 2, kNanField, 5, 8, 3, kNanField, 6, 9.25}) +
                    packed<std::int16_t>({-7, 8, -7, 8, -7, 8, -7, 8}));
}

std::vector<std::string> all_files() { return {kPcdText, binary_pcd(), compressed_file()}; }

TEST(ReadPcd, EveryEncodingGivesTheSame) {
  for (const std::string& bytes : all_files()) {
    const CloudFile file = parse("a.pcd", bytes);
    EXPECT_EQ(file.cloud.points, kPcdPoints);
    EXPECT_FALSE(file.cloud.viewpoint);
    EXPECT_EQ(file.report.num_declared, 4u);
    EXPECT_EQ(file.report.num_not_finite, 1u);
    EXPECT_THAT(file.report.warnings, ::testing::IsEmpty());
  }
}

// robustness 4
TEST(ReadPcd, OrganisedFilesKeepTheirGrid) {
  for (const std::string& bytes : all_files()) {
    const auto grid = parse("a.pcd", bytes).grid;
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->width, 2);
    EXPECT_EQ(grid->height, 2);
    EXPECT_EQ(grid->index, (std::vector<std::int32_t>{0, -1, 1, 2}));
    EXPECT_FALSE(parse("a.pcd", with(with(bytes, "WIDTH 2", "WIDTH 4"), "HEIGHT 2", "HEIGHT 1")).grid);
  }
}

// robustness 1
TEST(ReadPcd, EveryCutIsSeen) {
  for (const std::string& bytes : all_files()) testing::expect_cuts_are_seen("a.pcd", bytes);
}

// robustness 5
TEST(ReadPcd, LineEndsMarksAndSeparatorsDoNotMatter) {
  const std::string text = kPcdText;
  const std::string comment = std::string("# ").append(1 << 20, 'c').append("\n");
  const std::size_t body = text.find("1 2 3 0");
  for (const std::string& bytes :
       {with_all(text, "\n", "\r\n"), with_all(text, "\n", "\r"), with_all(text, " ", "\t"),
        text.substr(0, body) + with_all(text.substr(body), " ", ","), std::string("\xef\xbb\xbf").append(text),
        comment + text, with(binary_pcd(), "DATA binary\n", "DATA binary\r\n")})
    EXPECT_EQ(parse("a.pcd", bytes).cloud.points, kPcdPoints) << bytes.substr(0, 200);
}

TEST(ReadPcd, OlderVersionsLeaveLinesOut) {
  std::string text = with(kPcdText, "VIEWPOINT 0 0 0 1 0 0 0\n", "");
  for (const char* version : {"0.5", ".5", "0.6", ".6", ".7"})
    EXPECT_EQ(parse("a.pcd", with(text, "VERSION 0.7", std::string("VERSION ") + version)).cloud.points, kPcdPoints);
  text = with(with(text, "WIDTH 2\n", ""), "HEIGHT 2\n", "");
  EXPECT_EQ(parse("a.pcd", with(text, "FIELDS", "COLUMNS")).cloud.points, kPcdPoints);
}

TEST(ReadPcd, AViewpointOtherThanTheDefaultIsKept) {
  const auto viewpoint_of = [](const char* pose) {
    return parse("a.pcd", with(kPcdText, "0 0 0 1 0 0 0", pose)).cloud.viewpoint;
  };
  EXPECT_FALSE(viewpoint_of("0.0 0 0 1.0 0 0 -0"));
  EXPECT_EQ(viewpoint_of("0 0 0 0 1 0 0"), Vec3f(0, 0, 0));
  EXPECT_EQ(viewpoint_of("1 2 -3 1 0 0 0"), Vec3f(1, 2, -3));
}

TEST(ReadPcd, EveryTypeAndSize) {
  const std::tuple<const char*, const char*, std::string, double> cases[] = {
      {"I", "1", packed<std::int8_t>({-3}), -3},  {"U", "1", packed<std::uint8_t>({253}), 253},
      {"I", "2", packed<std::int16_t>({-3}), -3}, {"U", "2", packed<std::uint16_t>({253}), 253},
      {"I", "4", packed<std::int32_t>({-3}), -3}, {"U", "4", packed<std::uint32_t>({253}), 253},
      {"I", "8", packed<std::int64_t>({-3}), -3}, {"U", "8", packed<std::uint64_t>({253}), 253},
      {"F", "4", packed<float>({-3}), -3},        {"F", "8", packed<double>({-3}), -3}};
  for (const auto& [type, size, number, value] : cases) {
    const std::string t = type, s = size;
    const std::string bytes = "FIELDS X Y Z\nSIZE " + s + " " + s + " " + s + "\nTYPE " + t + " " + t + " " + t +
                              "\nPOINTS 1\nDATA binary\n" + number + number + number;
    EXPECT_EQ(places(parse("a.pcd", bytes).cloud)[0], Vec3d::Constant(value)) << type << size;
  }
}

TEST(ReadPcd, NormalsAreDirectionsOfPlanes) {
  const CloudFile file = parse("a.pcd",
                               "FIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\nPOINTS 2\n"
                               "DATA ascii\n0 0 1 0 0 -4\n0 0 2 nan 0 0\n");
  EXPECT_EQ(file.cloud.directions, (Points{{0, 0, -1}, {0, 0, 0}}));
  EXPECT_EQ(file.cloud.structures, (std::vector<Structure>{Structure::Planar, Structure::None}));
}

// robustness 2
TEST(ReadPcd, CountsThatCannotBeAreErrors) {
  for (const std::string& bytes : all_files())
    for (const char* count :
         {"0", "-1", "3", "40", "2147483647", "4294967296", "9223372036854775808", "1000000000", "nan", ""}) {
      const std::string number = count;
      expect_refused("a.pcd", with(bytes, "POINTS 4", "POINTS " + number), "a.pcd: ");
      expect_refused("a.pcd", with(bytes, "WIDTH 2", "WIDTH " + number), "a.pcd: ");
      expect_refused("a.pcd", with(bytes, "HEIGHT 2", "HEIGHT " + number), "a.pcd: ");
      const std::string unorganised = with(with(bytes, "HEIGHT 2", "HEIGHT 1"), "WIDTH 2", "WIDTH " + number);
      if (number != "3") expect_refused("a.pcd", with(unorganised, "POINTS 4", "POINTS " + number), "a.pcd: ");
    }
  EXPECT_EQ(testing::refusal("a.pcd", kPcdText, {.max_points = 3}), "a.pcd: expected at most 3 points, found 4");
}

// robustness 2
TEST(ReadPcd, CompressedLengthsThatCannotBeAreErrors) {
  const std::size_t at = header("binary_compressed").size();
  for (const std::uint32_t length : {0u, 1u, 0x7fffffffu, 0xffffffffu})
    for (const std::size_t which : {0u, 4u})
      expect_refused("a.pcd", compressed_file().replace(at + which, 4, packed<std::uint32_t>({length})),
                     "a.pcd: byte ");
  const std::string many =
      with(with(with(header("binary_compressed"), "WIDTH 2", "WIDTH 50000000"), "HEIGHT 2", "HEIGHT 1"), "POINTS 4",
           "POINTS 50000000");
  expect_refused("a.pcd", many + packed<std::uint32_t>({8, 800000000}) + "12345678",
                 "found 800000000 stated for 8 compressed");
}

// robustness 3
TEST(ReadPcd, FewerDeclaredThanPresentIsAWarning) {
  for (const std::string& bytes : {std::string(kPcdText), binary_pcd()}) {
    const CloudFile file = parse("a.pcd", with(with(bytes, "HEIGHT 2", "HEIGHT 1"), "POINTS 4", "POINTS 2"));
    EXPECT_EQ(file.report.num_declared, 2u);
    EXPECT_EQ(file.report.warnings.size(), 1u);
  }
}

TEST(ReadPcd, BytesBehindTheDeclaredAreAWarning) {
  for (const std::string& bytes : {binary_pcd(), compressed_file()})
    EXPECT_THAT(parse("a.pcd", bytes + "abc").report.warnings,
                ::testing::ElementsAre("3 bytes after the declared points were not read"));
  EXPECT_THAT(parse("a.pcd", compressed_file() + std::string(4000, '\0')).report.warnings, ::testing::IsEmpty());
}

// robustness 3
TEST(ReadPcd, HeadersThatMakeNoSenseAreErrors) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "expected 'DATA', the file ends before it"},
      {"1 2 3\n", "line 1: expected a keyword of a PCD header, found '1 2 3'"},
      {with(kPcdText, "VERSION 0.7", "VERSION 0.8"), "line 2: expected version 0.5, 0.6 or 0.7"},
      {with(kPcdText, "FIELDS x", "FIELDS w"), "expected a column 'x', found none"},
      {with(kPcdText, "FIELDS x y z", "FIELDS x y y"), "expected one column 'y', found a second"},
      {with(kPcdText, "FIELDS", "VERSION"), "line 3: expected VERSION once"},
      {with(kPcdText, "FIELDS x", "FIELDS"), "expected 4 values, one a field, found 5"},
      {with(kPcdText, "SIZE 4", "SIZE 3"),
       "line 4: expected type I or U of size 1, 2, 4 or 8, or F of 4 or 8; found 'F' of 3"},
      {with(kPcdText, "TYPE F", "TYPE Q"), "found 'Q' of 4"},
      {with(kPcdText, "SIZE 4", "SIZE 2"), "found 'F' of 2"},
      {with(kPcdText, "COUNT 1 1 1 3", "COUNT 0 1 1 3"), "line 6: expected a count from 1 to 65536, found 0"},
      {with(kPcdText, "COUNT 1 1 1 3", "COUNT 1 1 1 4294967296"), "found 4294967296"},
      {with(kPcdText, "COUNT 1", "COUNT 2"), "expected COUNT 1 of field 'x', found 2"},
      {with(kPcdText, "VIEWPOINT 0", "VIEWPOINT"), "line 9: expected VIEWPOINT tx ty tz qw qx qy qz"},
      {with(kPcdText, "VIEWPOINT 0", "VIEWPOINT nan"), "line 9: expected a finite number, found 'nan'"},
      {with(kPcdText, "DATA ascii", "DATA text"),
       "line 11: expected 'DATA ascii|binary|binary_compressed', found 'text'"},
      {with(kPcdText, "SIZE 4 4 4 1 2\n", ""), "expected SIZE before DATA"},
      {with(kPcdText, "FIELDS", std::string("FIELDS ").append(1 << 16, 'x')),
       "line 3: expected a line of at most 64 KB"},
      {with(kPcdText, "4 5 6", "4 5,5 6"), "line 14: expected a number, found '5,5'"},
      {with(kPcdText, "4 5 6 0", "4 5 6"), "line 14: expected 8 values, found 7"}};
  for (const auto& [bytes, message] : cases) expect_refused("a.pcd", bytes, message);
}

// robustness 15
TEST(ReadPcd, FarCoordinatesLoseNothing) {
  const std::string header = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 3\nDATA ";
  testing::expect_far_coordinates_survive(
      "a.pcd", [&](const std::vector<double>& v) { return header + "ascii\n" + testing::rows_of_three(v); });
  testing::expect_far_coordinates_survive(
      "a.pcd", [&](const std::vector<double>& v) { return header + "binary\n" + packed(v); });
  testing::expect_far_coordinates_survive("a.pcd", [&](const std::vector<double>& v) {
    const std::vector<double> by_field{v[0], v[3], v[6], v[1], v[4], v[7], v[2], v[5], v[8]};
    return header + "binary_compressed\n" + compressed(packed(by_field));
  });
}

TEST(ReadPcd, PaddingMayHaveNoBytes) {
  const std::string header =
      "VERSION 0.7\nFIELDS x _ y z\nSIZE 4 1 4 4\nTYPE F U F F\nCOUNT 1 0 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n";
  const std::vector<Vec3f> expected{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(testing::parse("a.pcd", header + "DATA ascii\n1 2 3\n4 5 6\n").cloud.points, expected);
  const std::string body = testing::packed<float>({1, 2, 3, 4, 5, 6});
  EXPECT_EQ(testing::parse("a.pcd", header + "DATA binary\n" + body).cloud.points, expected);
  testing::expect_refused("a.pcd", testing::with(header, "COUNT 1 0", "COUNT 0 0") + "DATA ascii\n1 2\n4 5\n",
                          "expected a count from 1");
}

}  // namespace
}  // namespace augicp
