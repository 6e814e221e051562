// SPDX-License-Identifier: MIT
#include "augicp/io/ros_image.h"

#include <random>

#include "augicp/io/bag_testing.h"
#include "augicp/io/depth_png.h"
#include "augicp/io/rvl.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;

MessageForm form_of(bool is_cdr) { return is_cdr ? MessageForm::Cdr : MessageForm::Ros1; }

testing::MessageWriter with_header(bool is_cdr) {
  testing::MessageWriter message(is_cdr);
  if (!is_cdr) message.number(1);
  message.number(7);
  message.number(8);
  message.text("camera");
  return message;
}

// Two rows of three pixels, with a gap behind each.
std::string image_message(bool is_cdr, const std::string& encoding, const std::string& pixels) {
  testing::MessageWriter message = with_header(is_cdr);
  message.number(2);
  message.number(3);
  message.text(encoding);
  message.byte(0);
  const std::size_t row_bytes = pixels.size() / 2;
  message.number(static_cast<std::uint32_t>(row_bytes + 5));
  message.number(static_cast<std::uint32_t>(2 * (row_bytes + 5)));
  const std::string gap(5, 'x');
  message.raw(pixels.substr(0, row_bytes) + gap + pixels.substr(row_bytes) + gap);
  return message.bytes();
}

std::string compressed_message(const std::string& format, const std::string& data) {
  testing::MessageWriter message = with_header(true);
  message.text(format);
  message.number(static_cast<std::uint32_t>(data.size()));
  message.raw(data);
  return message.bytes();
}

// A PNG with these values.
std::string png_of(const std::vector<std::uint16_t>& values, int width, int height) {
  const testing::TemporaryFolder folder;
  write_depth_png(folder / "a.png", depth_image(values, width, height, 1000.0), 1000.0);
  return read_bytes(folder / "a.png").bytes;
}

template <typename Read>
std::string refusal_of(const Read& read) {
  try {
    read();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(DepthMessage, RawImagesOfBothForms) {
  const std::string shorts = testing::packed<std::uint16_t>({1000, 0, 65535, 2500, 1, 500});
  const std::string floats = testing::packed<float>({1.0f, NAN, 0.0f, 2.5f, 0.001f, 0.5f});
  for (const bool is_cdr : {true, false})
    for (const auto& [encoding, pixels] :
         {std::pair{"16UC1", shorts}, std::pair{"mono16", shorts}, std::pair{"32FC1", floats}}) {
      const std::string message = image_message(is_cdr, encoding, pixels);
      EXPECT_EQ(image_encoding("bag", kImage, message, form_of(is_cdr)), encoding);
      const DepthImage image = parse_depth_message("bag", kImage, message, form_of(is_cdr), 1000.0);
      ASSERT_EQ(image.width, 3);
      ASSERT_EQ(image.height, 2);
      EXPECT_FLOAT_EQ(image.at(0, 0), 1.0f);
      EXPECT_TRUE(std::isnan(image.at(1, 0)) && std::isnan(image.at(2, 0)));
      EXPECT_FLOAT_EQ(image.at(0, 1), 2.5f);
      EXPECT_FLOAT_EQ(image.at(1, 1), 0.001f);
    }
}

TEST(DepthMessage, CutsAreRefused) {
  for (const bool is_cdr : {true, false}) {
    const std::string message = image_message(is_cdr, "16UC1", std::string(12, 'a'));
    // Behind the last row there is a gap that nobody needs, but the message states its length.
    for (std::size_t length = 0; length < message.size(); ++length)
      EXPECT_THAT(refusal_of([&] {
                    parse_depth_message("bag: /depth", kImage, message.substr(0, length), form_of(is_cdr), 1.0);
                  }),
                  HasSubstr("bag: /depth"));
  }
}

TEST(DepthMessage, CompressedPngsAreTheSameImage) {
  const std::vector<std::uint16_t> values{1000, 0, 3000, 2500};
  const std::string png = png_of(values, 2, 2), head(12, '\0');
  for (const auto& [format, data] : {std::pair<std::string, std::string>{"16UC1; compressedDepth png", head + png},
                                     {"16UC1; compressedDepth", head + png},
                                     {"16UC1; png compressed ", png}}) {
    ASSERT_TRUE(is_depth_encoding(format)) << format;
    const DepthImage image =
        parse_depth_message("bag", kCompressedImage, compressed_message(format, data), MessageForm::Cdr, 1000.0);
    EXPECT_FLOAT_EQ(image.at(0, 0), 1.0f);
    EXPECT_TRUE(std::isnan(image.at(1, 0)));
    EXPECT_FLOAT_EQ(image.at(1, 1), 2.5f);
  }
}

// A depth z is stored as a / z + b, rounded.
TEST(DepthMessage, InverseDepthsAreUndone) {
  constexpr float kA = 5000.0f, kB = 100.0f;
  const std::vector<float> depths{0.5f, 1.0f, 2.0f, 4.0f};
  std::vector<std::uint16_t> values;
  for (const float depth : depths) values.push_back(static_cast<std::uint16_t>(std::lround(kA / depth + kB)));
  const std::string data = testing::u32(0) + testing::packed<float>({kA, kB}) + png_of(values, 2, 2);
  const std::string message = compressed_message("32FC1; compressedDepth png", data);
  const DepthImage image = parse_depth_message("bag", kCompressedImage, message, MessageForm::Cdr, 1000.0);
  for (std::size_t i = 0; i < depths.size(); ++i) EXPECT_NEAR(image.depth[i], depths[i], 1e-3 * depths[i]);
}

// Runs of zeros and of differences, as the paper of RVL has them.
std::string rvl(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  std::uint32_t word = 0;
  int num_nibbles = 0;
  const auto put_nibble = [&](std::uint32_t nibble) {
    word = word << 4 | nibble;
    if (++num_nibbles < 8) return;
    bytes += testing::u32(word);
    num_nibbles = 0;
  };
  const auto put = [&](std::uint32_t number) {
    for (; number > 7; number >>= 3) put_nibble((number & 7) | 8);
    put_nibble(number);
  };
  int before = 0;
  for (std::size_t begin = 0; begin < values.size();) {
    std::size_t filled = begin;
    while (filled < values.size() && values[filled] == 0) ++filled;
    std::size_t end = filled;
    while (end < values.size() && values[end] != 0) ++end;
    put(static_cast<std::uint32_t>(filled - begin));
    put(static_cast<std::uint32_t>(end - filled));
    for (std::size_t i = filled; i < end; before = values[i++]) {
      const int difference = values[i] - before;
      put(static_cast<std::uint32_t>(difference < 0 ? -2 * difference - 1 : 2 * difference));
    }
    begin = end;
  }
  while (num_nibbles != 0) put_nibble(0);
  return bytes;
}

std::string rvl_message(const std::vector<std::uint16_t>& values, std::uint32_t width, std::uint32_t height) {
  return std::string(12, '\0') + testing::u32(width) + testing::u32(height) + rvl(values);
}

TEST(DepthMessage, RvlIsTheSameImage) {
  std::mt19937 random(7);
  std::vector<std::uint16_t> values;
  for (int i = 0; i < 40 * 30; ++i)
    values.push_back(
        random() % 5 == 0 ? 0 : static_cast<std::uint16_t>(random() % 3 == 0 ? 1 + random() % 65534 : 1500 + i));
  for (const std::vector<std::uint16_t>& image :
       {values, std::vector<std::uint16_t>(1200, 0), std::vector<std::uint16_t>(1200, 9)}) {
    const std::string message = compressed_message("16UC1; compressedDepth rvl", rvl_message(image, 40, 30));
    const DepthImage read = parse_depth_message("bag", kCompressedImage, message, MessageForm::Cdr, 1000.0);
    const DepthImage expected = depth_image(image, 40, 30, 1000.0);
    ASSERT_EQ(read.width, 40);
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (std::isnan(expected.depth[i])) {
        ASSERT_TRUE(std::isnan(read.depth[i])) << i;
      } else {
        ASSERT_EQ(read.depth[i], expected.depth[i]) << i;
      }
    }
  }
}

// The words of an image by hand: 2 zeros, 1 value, 5 = 10 folded; then 0 zeros, 1 value, -3 from it.
TEST(DepthMessage, RvlIsReadAsTheTextOfThePaperHasIt) {
  EXPECT_EQ(rvl_pixels(testing::u32(0x21a10150u), 4), (std::vector<std::uint16_t>{0, 0, 5, 2}));
}

TEST(DepthMessage, DamagedRvlIsRefused) {
  std::vector<std::uint16_t> values(1200, 700);
  for (std::size_t i = 0; i < values.size(); i += 7) values[i] = static_cast<std::uint16_t>(i);
  const std::string good = rvl_message(values, 40, 30);
  const auto refused = [](const std::string& data) {
    const std::string message = compressed_message("16UC1; compressedDepth rvl", data);
    return refusal_of([&] { parse_depth_message("bag", kCompressedImage, message, MessageForm::Cdr, 1000.0); });
  };
  EXPECT_EQ(refused(good), "");
  for (std::size_t length = 0; length < good.size(); ++length) ASSERT_NE(refused(good.substr(0, length)), "") << length;
  EXPECT_THAT(refused(good + testing::u32(0)), HasSubstr("damaged"));
  EXPECT_THAT(refused(rvl_message(values, 40, 31)), HasSubstr("1240 pixels"));
  EXPECT_THAT(refused(rvl_message(values, 40, 29)), HasSubstr("1160 pixels"));
  EXPECT_THAT(refused(rvl_message(values, 0xffffffffu, 2)), HasSubstr("pixels a side"));
  // One run of zeros may be an image that fills the memory.
  EXPECT_THAT(refused(rvl_message(values, 16384, 16384)), HasSubstr("at most 16777216 pixels"));
}

TEST(DepthMessage, WhatIsNoDepthIsRefused) {
  EXPECT_FALSE(is_depth_encoding("rgb8") || is_depth_encoding("bgr8; jpeg compressed bgr8"));
  EXPECT_THAT(refusal_of([] {
                parse_depth_message("bag", kImage, image_message(true, "rgb8", std::string(18, 'a')), MessageForm::Cdr,
                                    1.0);
              }),
              HasSubstr("found 'rgb8'"));
  const std::string other = compressed_message("16UC1; compressedDepth", std::string(99, 'a'));
  EXPECT_THAT(refusal_of([&] { parse_depth_message("bag", kCompressedImage, other, MessageForm::Cdr, 1.0); }),
              HasSubstr("republish"));
}

std::string camera_info(const std::string& model, const std::vector<double>& d) {
  std::string message = with_header(false).bytes() + testing::u32(480) + testing::u32(640) + testing::text_of(model) +
                        testing::u32(static_cast<std::uint32_t>(d.size())) + testing::packed<double>(d);
  return message + testing::packed<double>({500, 0, 320, 0, 501, 240, 0, 0, 1}) +
         testing::packed<double>({1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         testing::packed<double>({450, 0, 310, 0, 0, 451, 230, 0, 0, 0, 1, 0}) + std::string(29, '\0');
}

TEST(CameraInfo, HasCameraAndLens) {
  const std::string message = camera_info("plumb_bob", {0.1, -0.2, 0.001, 0.002, 0.3});
  const DepthCamera raw = parse_camera_info("bag", message, MessageForm::Ros1, false);
  EXPECT_EQ(raw.pinhole.fx, 500);
  EXPECT_EQ(raw.pinhole.fy, 501);
  EXPECT_EQ(raw.pinhole.cx, 320);
  EXPECT_EQ(raw.pinhole.cy, 240);
  EXPECT_EQ(raw.pinhole.width, 640);
  EXPECT_EQ(raw.distortion.p2, 0.002);
  EXPECT_EQ(raw.distortion.k3, 0.3);
  const DepthCamera rectified = parse_camera_info("bag", message, MessageForm::Ros1, true);
  EXPECT_EQ(rectified.pinhole.fx, 450);
  EXPECT_EQ(rectified.pinhole.cy, 230);
  EXPECT_TRUE(rectified.distortion.is_none());
}

TEST(CameraInfo, OtherLensesAreRefused) {
  for (const auto& [model, d] : {std::pair<std::string, std::vector<double>>{"equidistant", {0.1, 0, 0, 0}},
                                 {"rational_polynomial", {0.1, 0, 0, 0, 0, 0.5, 0, 0}},
                                 {"plumb_bob", {0.1}}})
    EXPECT_THAT(
        refusal_of([&, &m = model, &c = d] { parse_camera_info("bag", camera_info(m, c), MessageForm::Ros1, false); }),
        HasSubstr("plumb_bob"));
  EXPECT_TRUE(parse_camera_info("bag", camera_info("equidistant", {0, 0, 0, 0}), MessageForm::Ros1, false)
                  .distortion.is_none());
}

}  // namespace
}  // namespace augicp
