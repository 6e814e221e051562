// SPDX-License-Identifier: MIT
#include "augicp/io/grey_png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "augicp/io/depth_png.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

std::string from_hex(std::string_view digits) {
  std::string bytes;
  for (std::size_t at = 0; at + 1 < digits.size(); at += 2)
    bytes.push_back(static_cast<char>(std::stoi(std::string(digits.substr(at, 2)), nullptr, 16)));
  return bytes;
}

std::string png(std::string_view header, std::string_view pixels) {
  return from_hex("89504e470d0a1a0a0000000d494844520000000200000001" + std::string(header) + std::string(pixels) +
                  "0000000049454e44ae426082");
}

// Images of 2 x 1 pixels, their last chunks shared: grey 51 and 255; red and blue; the same, half and not at all
// opaque.
const std::string kGrey = png("0800000000d1492056", "0000000b4944415478da6330fe0f00016801331d7c2293");
const std::string kRgb = png("08020000007b40e8dd", "0000000d4944415478da63f8cf0004ff01070001ff3d7d8c49");
const std::string kRgba = png("0806000000f4227f8a", "000000114944415478da63f8cfc0d0c0c0f09f01000c7f027ff555ae82");
const std::string kGreyAlpha = png("08040000005e2bb701", "0000000d4944415478da6330feff9f010005cc02324a672915");

std::string grey_refusal(const std::string& bytes) {
  try {
    parse_grey_png({"colour.png", bytes});
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(GreyPng, GreyRgbAndRgbaBecomeBrightness) {
  const GreyImage grey = parse_grey_png({"grey.png", kGrey});
  EXPECT_EQ(grey.width, 2);
  EXPECT_EQ(grey.height, 1);
  EXPECT_THAT(grey.value, ::testing::ElementsAre(0.2f, 1.0f));
  for (const std::string& colours : {kRgb, kRgba})
    EXPECT_THAT(parse_grey_png({"colour.png", colours}).value,
                ::testing::ElementsAre(::testing::FloatEq(0.299f), ::testing::FloatEq(0.114f)));
}

TEST(GreyPng, OtherKindsAreErrors) {
  EXPECT_THAT(grey_refusal(kGreyAlpha), ::testing::HasSubstr("found 8-bit grey with alpha"));
  const testing::TemporaryFolder folder;
  write_depth_png(folder / "depth.png", {2, 1, {1.0f, 2.0f}}, 1000.0);
  EXPECT_THROW(read_grey_png(folder / "depth.png"), IoError);  // 16-bit grey
  EXPECT_THROW(read_grey_png(folder / "nothing.png"), IoError);
  EXPECT_THROW(parse_depth_png({"colour.png", kRgb}, 1000.0), IoError);
}

TEST(GreyPng, EveryCutAndEveryChangedByteOfThePixelsIsSeen) {
  for (std::size_t length = 0; length < kRgba.size(); ++length)
    EXPECT_THAT(grey_refusal(kRgba.substr(0, length)), ::testing::StartsWith("colour.png: ")) << length;
  for (std::size_t at = 12; at < kRgba.size() - 12; ++at) {
    std::string changed = kRgba;
    changed[at] = static_cast<char>(changed[at] ^ 0x40);
    EXPECT_NE(grey_refusal(changed), "") << at;
  }
}

}  // namespace
}  // namespace augicp
