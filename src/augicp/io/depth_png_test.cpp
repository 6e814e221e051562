// SPDX-License-Identifier: MIT
#include "augicp/io/depth_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

constexpr float kNoDepth = std::numeric_limits<float>::quiet_NaN();

std::string png_of(const DepthImage& image, double depth_scale) {
  const testing::TemporaryFolder folder;
  write_depth_png(folder / "depth.png", image, depth_scale);
  return read_bytes(folder / "depth.png").bytes;
}

std::string small_png() { return png_of({3, 2, {1.0f, kNoDepth, 2.5f, 0.25f, 10.0f, 0.001f}}, 1000.0); }

DepthImage parsed_png(const std::string& bytes) { return parse_depth_png({"depth.png", bytes}, 1000.0); }

std::string depth_refusal(const std::string& bytes) {
  try {
    parsed_png(bytes);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

void put_big_endian(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

// The header chunk: 8 bytes of mark, 4 of length, 4 of type, then width, height, depth, colour, ..., interlace, CRC.
constexpr std::size_t kWidth = 16, kHeight = 20, kBitDepth = 24, kColour = 25, kInterlace = 28, kCrc = 29;

std::string with_header(std::uint32_t width, std::uint32_t height, int bit_depth, int colour, int interlace) {
  std::string png = small_png();
  put_big_endian(png, kWidth, width);
  put_big_endian(png, kHeight, height);
  png[kBitDepth] = static_cast<char>(bit_depth);
  png[kColour] = static_cast<char>(colour);
  png[kInterlace] = static_cast<char>(interlace);
  put_big_endian(png, kCrc, crc_of(std::string_view(png).substr(12, 17)));
  return png;
}

TEST(DepthPng, WriteThenReadIsIdentity) {
  const DepthImage image = parsed_png(small_png());
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.at(0, 0), 1.0f);
  EXPECT_TRUE(std::isnan(image.at(1, 0)));
  EXPECT_EQ(image.at(2, 0), 2.5f);
  EXPECT_EQ(image.at(2, 1), 0.001f);
  EXPECT_EQ(parse_depth_png({"", png_of(image, 1000.0)}, 500.0).at(2, 0), 5.0f);
}

TEST(DepthPng, WhatDoesNotFitIsWrittenAsNoReading) {
  const DepthImage image =
      parsed_png(png_of({5, 1, {66.0f, -1.0f, kNoDepth, std::numeric_limits<float>::infinity(), 65.534f}}, 1000.0));
  for (int u = 0; u < 4; ++u) EXPECT_TRUE(std::isnan(image.at(u, 0))) << u;
  EXPECT_EQ(image.at(4, 0), 65.534f);
}

// robustness 1, 7
TEST(DepthPng, EveryCutIsAnError) {
  const std::string png = small_png();
  for (std::size_t length = 0; length < png.size(); ++length)
    EXPECT_NE(depth_refusal(png.substr(0, length)), "") << length;
}

// robustness 7: every byte is under a checksum, or part of the frame.
TEST(DepthPng, EveryFlippedByteIsAnError) {
  for (std::size_t i = 0; i < small_png().size(); ++i) {
    std::string png = small_png();
    png[i] = static_cast<char>(png[i] ^ 0x55);
    EXPECT_NE(depth_refusal(png), "") << i;
  }
}

// robustness 7
TEST(DepthPng, OtherKindsAreNamedInTheError) {
  ASSERT_EQ(depth_refusal(with_header(3, 2, 16, 0, 0)), "");
  const std::pair<std::string, const char*> cases[] = {{with_header(3, 2, 8, 0, 0), "found 8-bit grey"},
                                                       {with_header(3, 2, 16, 2, 0), "found 16-bit RGB"},
                                                       {with_header(3, 2, 8, 3, 0), "found 8-bit palette"},
                                                       {with_header(3, 2, 16, 4, 0), "found 16-bit grey with alpha"},
                                                       {with_header(3, 2, 16, 0, 1), "found 16-bit grey, interlaced"},
                                                       {with_header(100000, 100000, 16, 0, 0), "exceeds"},
                                                       {with_header(16384, 16384, 16, 0, 0), "too short"},
                                                       {"no PNG", "expected a whole PNG"},
                                                       {"", "expected a whole PNG"}};
  for (const auto& [bytes, message] : cases) EXPECT_THAT(depth_refusal(bytes), ::testing::HasSubstr(message));
}

// robustness 7
// Cameras that fill in the largest value mean "out of range"; taken as 65.535 m it would be a wall behind everything.
TEST(DepthPng, TheLargestValueIsNoReading) {
  std::string png = png_of({1, 1, {1.0f}}, 1000.0).substr(0, kCrc + 4);
  // An uncompressed block: no filter, the value ffff, and the checksum 1 + 0 + 255 + 255 over it.
  const std::string_view data("IDAT\x78\x01\x01\x03\x00\xfc\xff\x00\xff\xff\x03\x00\x01\xff", 18);
  const auto append_chunk = [&png](std::string_view chunk) {
    const std::size_t start = png.size();
    png.resize(start + 8 + chunk.size());
    put_big_endian(png, start, static_cast<std::uint32_t>(chunk.size() - 4));
    chunk.copy(png.data() + start + 4, chunk.size());
    put_big_endian(png, start + 4 + chunk.size(), crc_of(chunk));
  };
  append_chunk(data);
  append_chunk("IEND");
  EXPECT_TRUE(std::isnan(parsed_png(png).at(0, 0)));
}

TEST(DepthPng, AnImageWithoutReadingsIsRead) {
  const DepthImage image = parsed_png(png_of({2, 1, {kNoDepth, 0.0f}}, 1000.0));
  EXPECT_TRUE(std::isnan(image.at(0, 0)) && std::isnan(image.at(1, 0)));
  EXPECT_NO_THROW(check_depth_scale(image, "depth.png", 1000.0));
}

// robustness 7
TEST(DepthPng, AnUnlikelyMedianDepthIsBlamedOnTheScale) {
  const auto image_at = [](float depth) { return DepthImage{3, 1, {depth, kNoDepth, depth}}; };
  for (float depth : {0.05f, 1.0f, 200.0f}) EXPECT_NO_THROW(check_depth_scale(image_at(depth), "depth.png", 1000.0));
  for (float depth : {0.04f, 201.0f}) {
    EXPECT_THROW(check_depth_scale(image_at(depth), "depth.png", 1000.0), IoError);
  }
}

TEST(DepthPng, ArgumentsAreChecked) {
  EXPECT_THROW(parse_depth_png({"", small_png()}, 0.0), std::invalid_argument);
  EXPECT_THROW(write_depth_png("depth.png", {2, 1, {1.0f}}, 1000.0), std::invalid_argument);
  EXPECT_THROW(write_depth_png("depth.png", {}, 1000.0), std::invalid_argument);
}

// robustness 9
TEST(DepthPng, WritingToAFullDiskIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  EXPECT_THROW(write_depth_png("/dev/full", {1, 1, {1.0f}}, 1000.0), IoError);
}

TEST(DepthPng, ADepthScaleIsSuspectedByTheRange) {
  DepthImage image;
  image.width = 40;
  image.height = 30;
  const auto readings = [&](float near, float far) {
    image.depth.clear();
    for (int i = 0; i < 1200; ++i) image.depth.push_back(near + (far - near) * static_cast<float>(i) / 1199.0f);
    return depth_scale_suspicion(image, 1000.0).has_value();
  };
  EXPECT_FALSE(readings(0.5f, 4.0f));
  EXPECT_TRUE(readings(0.1f, 0.8f));   // millimetres read as TUM's
  EXPECT_TRUE(readings(2.5f, 20.0f));  // TUM's read as millimetres
  readings(0.5f, 4.0f);
  image.depth.front() = 0.01f;  // a single one is no reason
  image.depth.back() = 60.0f;
  EXPECT_FALSE(depth_scale_suspicion(image, 1000.0));
  image.depth.assign(1200, std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(depth_scale_suspicion(image, 1000.0));
}

}  // namespace
}  // namespace augicp
