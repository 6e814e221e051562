// SPDX-License-Identifier: MIT
// Depth images and cameras in messages of ROS 1 and ROS 2.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "augicp/io/message_reader.h"
#include "augicp/sensor/depth_camera.h"

namespace augicp {

inline constexpr const char* kImage = "sensor_msgs/Image";
inline constexpr const char* kCompressedImage = "sensor_msgs/CompressedImage";
inline constexpr const char* kCameraInfo = "sensor_msgs/CameraInfo";

// The encoding of an Image ("16UC1") or the format of a CompressedImage ("16UC1; compressedDepth png"). Throws IoError.
std::string image_encoding(const std::filesystem::path& source, std::string_view type, std::string_view message,
                           MessageForm form);

// Whether images of this encoding or format are depth that parse_depth_message() reads, or refuses with a way around.
bool is_depth_encoding(std::string_view encoding);

// A depth image from an Image or CompressedImage:
//   16UC1, mono16            values / depth_scale; 0 and 65535 are no reading
//   32FC1                    metres
//   16UC1; compressedDepth   a PNG of 16 bits, behind 12 bytes; or, if the format has "rvl", RVL, see rvl.h
//   32FC1; compressedDepth   the same with inverse depths, quantised: depth = a / (value - b), a and b in the 12 bytes
//   16UC1; png               a PNG of 16 bits
// Images have at most 16384 pixels a side. Throws IoError that begins with `source` for any other and for damage.
// REQUIRES: depth_scale above 0.
DepthImage parse_depth_message(const std::filesystem::path& source, std::string_view type, std::string_view message,
                               MessageForm form, double depth_scale);

// The camera of a CameraInfo: K and the lens D (plumb_bob), or if the images are rectified P without a lens. Throws
// IoError for damage, and for lenses of other models whose coefficients are not zero.
DepthCamera parse_camera_info(const std::filesystem::path& source, std::string_view message, MessageForm form,
                              bool are_rectified);

}  // namespace augicp
