// SPDX-License-Identifier: MIT
#include "augicp/io/read_ply.h"

#include <algorithm>

#include "augicp/io/reader_testing.h"
#include "augicp/testing/matchers.h"

namespace augicp {
namespace {

using testing::expect_refused;
using testing::packed;
using testing::parse;
using testing::places;
using testing::with;
using testing::with_all;
using Points = std::vector<Vec3f>;

constexpr const char* kPlyText =
    "ply\n"
    "format ascii 1.0\n"
    "comment made by hand\n"
    "element vertex 3\n"
    "property float x\n"
    "property float y\n"
    "property float z\n"
    "element face 1\n"
    "property list uchar int vertex_indices\n"
    "end_header\n"
    "1 2 3\n"
    "4 5 6\n"
    "7 8 9.25\n"
    "3 0 1 2\n";
const Points kPlyPoints{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.25}};

std::string binary_ply() {
  const std::string header = std::string(kPlyText).substr(0, std::string_view(kPlyText).find("1 2 3"));
  return with(header, "ascii", "binary_little_endian") + packed<float>({1, 2, 3, 4, 5, 6, 7, 8, 9.25}) +
         std::string("\3") + packed<std::int32_t>({0, 1, 2});
}

TEST(ReadPly, TextAndBinaryGiveTheSame) {
  for (const std::string& bytes : {std::string(kPlyText), binary_ply()}) {
    const CloudFile file = parse("a.ply", bytes);
    EXPECT_EQ(file.cloud.points, kPlyPoints);
    EXPECT_EQ(file.report.num_declared, 3u);
    EXPECT_FALSE(file.report.has_normals);
    EXPECT_FALSE(file.grid);
    EXPECT_THAT(file.report.warnings, ::testing::IsEmpty());
  }
}

// robustness 1
TEST(ReadPly, EveryCutIsSeen) {
  testing::expect_cuts_are_seen("a.ply", kPlyText);
  testing::expect_cuts_are_seen("a.ply", binary_ply());
}

// robustness 5
TEST(ReadPly, LineEndsBlanksMarksAndCommentsDoNotMatter) {
  const std::string text = kPlyText;
  const std::string comment = std::string("comment ").append(1 << 20, 'c').append("\n");
  for (const std::string& bytes :
       {with_all(text, "\n", "\r\n"), with_all(text, "\n", "\r"), with_all(text, "\n", "  \n"),
        with_all(text, " ", "\t"), std::string("\xef\xbb\xbf").append(text),
        with(text, "element", std::string(comment).append("element")),
        with(text, "end_header", "obj_info x\nend_header"), with(binary_ply(), "end_header\n", "end_header\r\n")})
    EXPECT_EQ(parse("a.ply", bytes).cloud.points, kPlyPoints);
  expect_refused("a.ply", with(text, "float x", std::string("float ").append(1 << 16, 'x')),
                 "line 5: expected a line of at most 64 KB");
}

TEST(ReadPly, ABinaryBodyMayStartWithTheByteOfALineEnd) {
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char "
      "z\nend_header\n";
  EXPECT_EQ(places(parse("a.ply", header + "\n\r\n").cloud)[0], Vec3d(10, 13, 10));
  EXPECT_EQ(places(parse("a.ply", with_all(header, "\n", "\r") + "\n\r\n").cloud)[0], Vec3d(10, 13, 10));
}

struct TypeCase {
  const char* names[2];
  std::string bytes;  // -3, or 253 if the type is unsigned
  double value;
};

// robustness 5
TEST(ReadPly, EveryTypeUnderBothNamesInBothByteOrders) {
  const TypeCase cases[] = {
      {{"char", "int8"}, packed<std::int8_t>({-3}), -3},    {{"uchar", "uint8"}, packed<std::uint8_t>({253}), 253},
      {{"short", "int16"}, packed<std::int16_t>({-3}), -3}, {{"ushort", "uint16"}, packed<std::uint16_t>({253}), 253},
      {{"int", "int32"}, packed<std::int32_t>({-3}), -3},   {{"uint", "uint32"}, packed<std::uint32_t>({253}), 253},
      {{"float", "float32"}, packed<float>({-3.0f}), -3},   {{"double", "float64"}, packed<double>({-3.0}), -3}};
  for (const TypeCase& type : cases)
    for (const char* name : type.names)
      for (const bool big : {false, true}) {
        std::string number = type.bytes;
        if (big) std::reverse(number.begin(), number.end());
        const std::string property = std::string("property ").append(name).append(" ");
        const std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                                 "_endian 1.0\nelement vertex 2\n" + property + "x\n" + property + "y\n" + property +
                                 "z\nend_header\n" + number + number + number + std::string(3 * number.size(), '\0');
        EXPECT_EQ(places(parse("a.ply", file).cloud)[0], Vec3d::Constant(type.value)) << name << (big ? " big" : "");
      }
}

TEST(ReadPly, OtherElementsMayComeFirst) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 2\nproperty list uchar int i\nproperty float q\nelement empty "
      "9223372036854775808\n"
      "element vertex 1\nproperty double x\nproperty double y\nproperty int skipped\nproperty double z\nend_header\n"
      "2 7 7 0.5\n0 0.5\n1 2 -9 3\n";
  EXPECT_EQ(places(parse("a.ply", text).cloud)[0], Vec3d(1, 2, 3));
  const std::string header = with(text.substr(0, text.find("2 7 7")), "ascii", "binary_little_endian");
  const std::string body = std::string("\2") + packed<std::int32_t>({7, 7}) + packed<float>({0.5f}) +
                           std::string(1, '\0') + packed<float>({0.5f}) + packed<double>({1, 2}) +
                           packed<std::int32_t>({-9}) + packed<double>({3});
  EXPECT_EQ(places(parse("a.ply", header + body).cloud)[0], Vec3d(1, 2, 3));
}

TEST(ReadPly, NormalsAreDirectionsOfPlanes) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nend_header\n0 0 1 0 0 -4\n0 0 2 0 0 0\n";
  const CloudFile file = parse("a.ply", text);
  EXPECT_TRUE(file.report.has_normals);
  EXPECT_EQ(file.cloud.directions, (Points{{0, 0, -1}, {0, 0, 0}}));
  EXPECT_EQ(file.cloud.structures, (std::vector<Structure>{Structure::Planar, Structure::None}));
  EXPECT_FALSE(file.cloud.viewpoint);
}

TEST(ReadPly, IntensitiesAreRead) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
      "property float scalar_Intensity\nend_header\n0 0 1 0.5\n0 0 2 70\n";
  EXPECT_EQ(parse("a.ply", text).cloud.intensities, (std::vector<float>{0.5f, 70.0f}));
  EXPECT_TRUE(parse("a.ply", testing::with(text, "scalar_Intensity", "scalar_Time")).cloud.intensities.empty());
}

// robustness 2
TEST(ReadPly, CountsThatCannotBeAreErrors) {
  for (const std::string& bytes : {std::string(kPlyText), binary_ply()})
    for (const char* count :
         {"0", "-1", "2147483647", "4294967296", "9223372036854775808", "1000000000", "nan", "30", "3.0", ""})
      for (const char* element : {"vertex 3", "face 1"}) {
        const std::string name = std::string(element).substr(0, std::string_view(element).find(' ') + 1);
        if (name == "face " && std::string_view(count) == "0") continue;  // that is allowed
        expect_refused("a.ply", with(bytes, element, name + count), "a.ply: ");
      }
  EXPECT_EQ(testing::refusal("a.ply", kPlyText, {.max_points = 2}), "a.ply: expected at most 2 points, found 3");
}

// robustness 3
TEST(ReadPly, FewerDeclaredThanPresentIsAWarning) {
  const CloudFile text = parse("a.ply", with(kPlyText, "face 1", "face 0"));
  EXPECT_THAT(text.report.warnings, ::testing::ElementsAre("lines after the declared elements were not read"));
  const CloudFile binary = parse("a.ply", binary_ply() + "12345");
  EXPECT_THAT(binary.report.warnings, ::testing::ElementsAre("5 bytes after the declared elements were not read"));
  EXPECT_EQ(text.cloud.points, kPlyPoints);
  EXPECT_EQ(binary.cloud.points, kPlyPoints);
}

// robustness 3
TEST(ReadPly, HeadersThatMakeNoSenseAreErrors) {
  const std::string text = kPlyText;
  const std::pair<std::string, const char*> cases[] = {
      {with(text, "ply", "plx"), "line 1: expected 'ply', the mark of a PLY file, found 'plx'"},
      {with(text, "ascii", "asci"), "line 2: expected 'format ascii"},
      {with(text, "1.0", "2.0"), "line 2: expected 'format ascii"},
      {with(text, "float x", "float w"), "expected a column 'x', found none"},
      {with(text, "float y", "float x"), "line 6: expected each property of an element once"},
      {with(text, "float x", "half x"), "line 5: expected a known type, found 'property half x'"},
      {with(text, "float x", "list uchar float x"), "expected single numbers of element 'vertex', found the list 'x'"},
      {with(text, "list uchar", "list float"), "line 9: expected a list length of an integer type"},
      {with(text, "face 1", "vertex 1"), "line 8: expected each element once"},
      {with(text, "vertex 3", "point 3"), "expected an element 'vertex', found none"},
      {with(text, "element vertex 3\n", ""), "line 4: expected an element before its properties"},
      {with(text, "end_header", "end"), "expected 'element', 'property' or 'end_header', found 'end'"},
      {with(text, "end_header", "end_header 1 2 3"), "expected nothing behind 'end_header', found 'end_header 1 2 3'"},
      {with(text, "4 5 6", "4 5"), "line 12: expected 3 values, found 2: '4 5'"},
      {with(text, "4 5 6", "4 5 6 7"), "line 12: expected 3 values, found 4"},
      {with(text, "4 5 6", "4 5,5 6"), "line 12: expected a number, found '5,5'"},
      {with(text, "3 0 1 2", "-3 0 1 2"), "line 14: expected a list length, found '-3'"},
      {with_all(with_all(with(text, "7 8 9.25", "nan 0 0"), "1 2 3", "inf 0 0"), "4 5 6", "1e308 0 0"),
       "none of its 3 points is finite"}};
  for (const auto& [bytes, message] : cases) expect_refused("a.ply", bytes, message);
  expect_refused("a.ply",
                 with(with(binary_ply(), "list uchar", "list char"), std::string("\3\0\0\0\0\1", 6),
                      std::string("\xff\0\0\0\0\1", 6)),
                 "expected a list length, found -1");
}

// robustness 15
TEST(ReadPly, FarCoordinatesLoseNothing) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  testing::expect_far_coordinates_survive(
      "a.ply", [&](const std::vector<double>& v) { return header + testing::rows_of_three(v); });
  testing::expect_far_coordinates_survive(
      "a.ply", [&](const std::vector<double>& v) { return with(header, "ascii", "binary_little_endian") + packed(v); });
}

}  // namespace
}  // namespace augicp
