// SPDX-License-Identifier: MIT
#include "augicp/io/depth_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;
using testing::packed;

std::string refusal_of_image(const std::string& name, const std::string& bytes) {
  try {
    parse_depth_image({name, bytes}, 1000.0);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

std::string npy(const std::string& type, const std::string& shape, const std::string& body, bool fortran = false) {
  const std::string text =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + packed<std::uint16_t>({static_cast<std::uint16_t>(text.size())}) + text +
         body;
}

// Two rows of three pixels, with no reading in the second and the fifth.
void expect_the_image(const std::string& name, const std::string& bytes) {
  SCOPED_TRACE(name);
  const DepthImage image = parse_depth_image({name, bytes}, 1000.0);
  ASSERT_EQ(image.width, 3);
  ASSERT_EQ(image.height, 2);
  const float expected[] = {0.5f, 0.0f, 1.0f, 2.0f, 0.0f, 3.5f};
  for (std::size_t i = 0; i < 6; ++i) {
    if (expected[i] == 0.0f) {
      EXPECT_TRUE(std::isnan(image.depth[i])) << i;
    } else {
      EXPECT_FLOAT_EQ(image.depth[i], expected[i]) << i;
    }
  }
}

const std::string kPgm =
    std::string("P5\n# a comment\n3 2 65535\n") + std::string("\x01\xf4\x00\x00\x03\xe8\x07\xd0\xff\xff\x0d\xac", 12);

TEST(DepthFile, EveryFormatHasTheSameImage) {
  expect_the_image("a.pgm", kPgm);
  expect_the_image("a.npy", npy("<f4", "(2, 3)", packed<float>({0.5f, 0.0f, 1.0f, 2.0f, NAN, 3.5f})));
  expect_the_image("a.npy", npy("<f8", "(2, 3)", packed<double>({0.5, 2.0, INFINITY, -1.0, 1.0, 3.5}), true));
  expect_the_image("a.npy", npy("<u2", "(2, 3)", packed<std::uint16_t>({500, 0, 1000, 2000, 65535, 3500})));
  expect_the_image("a.npy", npy("<f2", "(2, 3)", packed<std::uint16_t>({0x3800, 0, 0x3c00, 0x4000, 0x7e00, 0x4300})));
}

const std::string kPfm = "Pf\n3 2\n-1.0\n" + packed<float>({2.0f, INFINITY, 3.5f, 0.5f, 0.0f, 1.0f});

// The lowest row comes first.
TEST(DepthFile, PfmHasTheSameImage) {
  expect_the_image("a.pfm", kPfm);
  std::string big = "Pf\n3 2\n1.0\n";
  for (const float metres : {2.0f, -1.0f, 3.5f, 0.5f, NAN, 1.0f}) {
    const std::string little = packed<float>({metres});
    big.append(little.rbegin(), little.rend());
  }
  expect_the_image("a.pfm", big);
}

TEST(DepthFile, AFurtherSideOfOneIsIgnored) {
  const std::string body = packed<float>({0.5f, 0.0f, 1.0f, 2.0f, NAN, 3.5f});
  expect_the_image("a.npy", npy("<f4", "(2, 3, 1)", body));
  expect_the_image("a.npy", npy("<f4", "(1, 2, 3)", body));
}

// robustness 1
TEST(DepthFile, CutsAreRefused) {
  const std::string array = npy("<f4", "(2, 3)", packed<float>({1, 2, 3, 4, 5, 6}));
  for (std::size_t length = 0; length < kPgm.size(); ++length)
    EXPECT_NE(refusal_of_image("a.pgm", kPgm.substr(0, length)), "") << length;
  for (std::size_t length = 0; length < array.size(); ++length)
    EXPECT_NE(refusal_of_image("a.npy", array.substr(0, length)), "") << length;
  for (std::size_t length = 0; length < kPfm.size(); ++length)
    EXPECT_NE(refusal_of_image("a.pfm", kPfm.substr(0, length)), "") << length;
  EXPECT_THAT(refusal_of_image("a.pgm", kPgm + "x"), HasSubstr("found more"));
}

TEST(DepthFile, OtherImagesAreRefused) {
  EXPECT_THAT(refusal_of_image("a.pgm", "P2\n1 1 65535\n7\n"), HasSubstr("'P5'"));
  EXPECT_THAT(refusal_of_image("a.pgm", "P5\n1 1 255\nx"), HasSubstr("16-bit"));
  EXPECT_THAT(refusal_of_image("a.pgm", "P5\n99999 99999 65535\nx"), HasSubstr("pixels a side"));
  EXPECT_THAT(refusal_of_image("a.npy", npy("<f4", "(2, 3, 3)", std::string(72, 'a'))), HasSubstr("(H, W)"));
  EXPECT_THAT(refusal_of_image("a.npy", npy("<f4", "(0, 3)", "")), HasSubstr("pixels a side"));
  EXPECT_THAT(refusal_of_image("a.npy", npy("<f4", "(2, 3, 3)", "")), HasSubstr("found '(2, 3, 3)'"));
  EXPECT_THAT(refusal_of_image("a.pfm", "PF\n1 1\n-1\n"), HasSubstr("'Pf'"));
  EXPECT_THAT(refusal_of_image("a.pfm", "Pf\n1 1\n0\nabcd"), HasSubstr("scale"));
  EXPECT_THAT(refusal_of_image("a.exr", "v/1"), HasSubstr("oiiotool"));
  EXPECT_THAT(refusal_of_image("a.JPG", ""), HasSubstr("lost its depths"));
  EXPECT_THROW(parse_depth_image({"a.pgm", kPgm}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace augicp
