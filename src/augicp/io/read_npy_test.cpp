// SPDX-License-Identifier: MIT
#include "augicp/io/read_npy.h"

#include <algorithm>
#include <limits>

#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using testing::expect_refused;
using testing::packed;
using testing::parse;
using testing::with;
using Points = std::vector<Vec3f>;

const Points kPoints{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.25}};

std::string npy(const std::string& descr, const std::string& fortran, const std::string& shape, const std::string& body,
                char version = 1) {
  std::string header = "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  header.append(63 - header.size() % 64, ' ').append("\n");
  const std::string length = version == 1 ? packed<std::uint16_t>({static_cast<std::uint16_t>(header.size())})
                                          : packed<std::uint32_t>({static_cast<std::uint32_t>(header.size())});
  return std::string("\x93NUMPY") + version + '\0' + length + header + body;
}

std::string small_npy() { return npy("<f4", "False", "(3, 3)", packed<float>({1, 2, 3, 4, 5, 6, 7, 8, 9.25})); }

TEST(ReadNpy, EveryLayoutGivesTheSame) {
  const std::vector<double> numbers{1, 2, 3, 4, 5, 6, 7, 8, 9.25};
  std::string big = packed(std::vector<double>(numbers.rbegin(), numbers.rend()));
  std::reverse(big.begin(), big.end());
  for (const std::string& bytes :
       {small_npy(), npy("<f8", "False", "(3, 3)", packed(numbers)), npy(">f8", "False", "(3,3)", big),
        npy("<f8", "True", "(3, 3)", packed<double>({1, 4, 7, 2, 5, 8, 3, 6, 9.25})),
        npy("<f8", "False", "(3, 3)", packed(numbers), 2), npy("<f8", "False", "(3, 3)", packed(numbers), 3),
        npy("<f4", "False", "(3, 4)", packed<float>({1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9.25, 0})),
        npy("<f4", "True", "(3, 4)", packed<float>({1, 4, 7, 2, 5, 8, 3, 6, 9.25, 0, 0, 0}))}) {
    const CloudFile file = parse("a.npy", bytes);
    EXPECT_EQ(file.cloud.points, kPoints);
    EXPECT_FALSE(file.grid);
    EXPECT_THAT(file.report.warnings, ::testing::IsEmpty());
  }
}

// robustness 4
TEST(ReadNpy, ThreeAxesAreAnOrganisedCloud) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> rows{1, 2, 3, nan, 0, 0, 4, 5, 6, 7, 8, 9.25f, nan, 0, 0, 0, nan, 0};
  std::vector<float> fortran(rows.size());
  for (std::size_t v = 0; v < 2; ++v)
    for (std::size_t u = 0; u < 3; ++u)
      for (std::size_t c = 0; c < 3; ++c) fortran[v + 2 * u + 6 * c] = rows[(v * 3 + u) * 3 + c];
  for (const std::string& bytes :
       {npy("<f4", "False", "(2, 3, 3)", packed(rows)), npy("<f4", "True", "(2, 3, 3)", packed(fortran))}) {
    const CloudFile file = parse("a.npy", bytes);
    EXPECT_EQ(file.cloud.points, kPoints);
    ASSERT_TRUE(file.grid);
    EXPECT_EQ(file.grid->width, 3);
    EXPECT_EQ(file.grid->height, 2);
    EXPECT_EQ(file.grid->index, (std::vector<std::int32_t>{0, -1, 1, 2, -1, -1}));
  }
}

// robustness 1, 3
TEST(ReadNpy, EveryCutIsAnErrorAndMoreIsAWarning) {
  for (std::size_t length = 0; length < small_npy().size(); ++length)
    EXPECT_NE(testing::refusal("a.npy", small_npy().substr(0, length)), "") << length;
  EXPECT_THAT(parse("a.npy", small_npy() + "12").report.warnings,
              ::testing::ElementsAre("2 bytes after the array were not read"));
}

// robustness 2
TEST(ReadNpy, ShapesThatCannotBeAreErrors) {
  for (const char* shape :
       {"(0, 3)", "(3, 0)", "(-1, 3)", "(2147483647, 3)", "(4294967296, 3)", "(9223372036854775808, 3)", "(30, 3)",
        "(3, 9223372036854775808)", "(4294967296, 4294967296, 3)", "(nan, 3)", "(9,)", "()", "(3, 3", "3, 3", "(3, 2)",
        "(1, 1, 3, 3)", "(1000000000, 1000000000, 1000000000)"})
    expect_refused("a.npy", npy("<f4", "False", shape, packed<float>({1, 2, 3, 4, 5, 6, 7, 8, 9.25})), "a.npy: ");
  EXPECT_NE(testing::refusal("a.npy", small_npy(), {.max_points = 2}), "");
}

// robustness 3
TEST(ReadNpy, CoordinatesAsRowsAreRefused) {
  const std::string body = packed<float>(std::vector<float>(36, 1.0f));
  for (const char* shape : {"(3, 12)", "(4, 9)", "(3, 9)"})
    expect_refused("a.npy", npy("<f4", "False", shape, body), "is it transposed?");
  for (const char* shape : {"(12, 3)", "(6, 4)", "(3, 3)", "(3, 4)", "(4, 8)", "(2, 12)"})
    EXPECT_GE(parse("a.npy", npy("<f4", "False", shape, body)).cloud.size(), 2u) << shape;
}

TEST(ReadNpy, HeadersThatMakeNoSenseAreErrors) {
  const std::string body = packed<float>({1, 2, 3});
  const std::pair<std::string, const char*> cases[] = {
      {"numpy, or not", "byte 0: expected the mark of a NumPy array"},
      {npy("<f4", "False", "(1, 3)", body, 4), "byte 6: expected version 1, 2 or 3, found 4"},
      {npy("<c8", "False", "(1, 3)", body),
       "expected numbers of float16, float32, float64 or an integer type, or named ones, found ''<c8'"},
      {npy("<f3", "False", "(1, 3)", body), "found ''<f3'"},
      {npy("<f4", "Maybe", "(1, 3)", body), "expected True or False of 'fortran_order', found 'Maybe"},
      {with(small_npy(), "'descr'", "'d'"), "expected 'descr' in the header"},
      {with(small_npy(), "'shape'", "'s'"), "expected 'shape' in the header"},
      {npy("<f4", "False", "(1, 3)", body, 2).replace(8, 4, "\xff\xff\xff\xff"), "found length 4294967295"}};
  for (const auto& [bytes, message] : cases) expect_refused("a.npy", bytes, message);
}

// robustness 15
TEST(ReadNpy, FarCoordinatesLoseNothing) {
  testing::expect_far_coordinates_survive(
      "a.npy", [](const std::vector<double>& v) { return npy("<f8", "False", "(3, 3)", packed(v)); });
}

TEST(ReadNpy, IntegersAndHalvesAreNumbers) {
  EXPECT_EQ(parse("a.npy", npy("<i2", "False", "(2, 3)", packed<std::int16_t>({1, -2, 3, 4, 5, -600}))).cloud.points,
            (std::vector<Vec3f>{{1, -2, 3}, {4, 5, -600}}));
  EXPECT_EQ(parse("a.npy", npy("|u1", "True", "(2, 3)", packed<std::uint8_t>({1, 4, 2, 5, 3, 255}))).cloud.points,
            (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 255}}));
  // One, minus two, the largest, the least above zero, infinity, NaN; IEEE 754, table 3.5.
  const CloudFile halves = parse(
      "a.npy", npy("<f2", "False", "(3, 3)",
                   packed<std::uint16_t>({0x3c00, 0xc000, 0x7bff, 0x0001, 0x0400, 0x8000, 0x7c00, 0x3c00, 0x7e00})));
  EXPECT_EQ(halves.cloud.points, (std::vector<Vec3f>{{1, -2, 65504}, {std::exp2(-24.0f), std::exp2(-14.0f), -0.0f}}));
  EXPECT_EQ(halves.report.num_not_finite, 1u);
}

TEST(ReadNpy, StructuredArraysHaveNames) {
  std::string header = npy("<f4", "False", "(2,)", "");
  const std::string descr =
      "[('intensity', '<u2'), ('y', '<f4'), ('x', '<f8'), ('', '|V3'), ('z', '<f4'), ('rgb', '|u1', (3,))]";
  const auto structured = [&](const std::string& members, const std::string& shape, const std::string& body) {
    const std::string text = "{'descr': " + members + ", 'fortran_order': False, 'shape': " + shape + ", }\n";
    return std::string("\x93NUMPY\x01\x00", 8) + packed<std::uint16_t>({static_cast<std::uint16_t>(text.size())}) +
           text + body;
  };
  std::string body;
  for (int i = 0; i < 2; ++i)
    body += packed<std::uint16_t>({static_cast<std::uint16_t>(7 + i)}) + packed<float>({2}) +
            packed<double>({1.0 + i}) + "abc" + packed<float>({3}) + std::string("RGB");
  const CloudFile file = parse("a.npy", structured(descr, "(2,)", body), {.keep_fields = true});
  EXPECT_EQ(file.cloud.points, (std::vector<Vec3f>{{1, 2, 3}, {2, 2, 3}}));
  EXPECT_EQ(file.cloud.intensities, (std::vector<float>{7, 8}));
  ASSERT_EQ(file.fields.fields.size(), 2u);
  EXPECT_EQ(file.fields.fields[1].values, "RGBRGB");
  EXPECT_EQ(parse("a.npy", structured(descr, "(1, 2)", body)).grid->width, 2);
  for (std::size_t length = 0; length < body.size(); ++length)
    EXPECT_NE(testing::refusal("a.npy", structured(descr, "(2,)", body.substr(0, length))), "") << length;
  for (const char* wrong : {"[('x', '<f4')]", "[]", "[('x', '<f4'", "[('x', '<f4', (0,))]", "[('x', 'O')]",
                            "[('x', '<f4'), ('y', '<f4'), ('z', '<f4', (2,))]",
                            "[('x', '<f4'), ('y', '>f4'), ('z', '<f4')]", "[('x', '<V99999')]"})
    EXPECT_NE(testing::refusal("a.npy", structured(wrong, "(1,)", std::string(100, 'a'))), "") << wrong;
  expect_refused("a.npy", structured(descr, "(1, 1, 2)", body), "expected the shape (N,) or (H, W)");
}

}  // namespace
}  // namespace augicp
