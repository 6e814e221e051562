// SPDX-License-Identifier: MIT
// What the texts of cameras have in common. All functions throw std::invalid_argument that begins with "camera: ".
#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "augicp/sensor/depth_camera.h"

namespace augicp {

// The numbers of a key; empty if the text lacks it.
using Numbers = std::optional<std::vector<double>>;

// Those of the first key that the text has.
template <typename Value>
Numbers first_value(std::initializer_list<const char*> keys, const Value& value_of) {
  for (const char* key : keys)
    if (Numbers numbers = value_of(key)) return numbers;
  return std::nullopt;
}

// A width or a height, pixels; 0 if it is not stated.
int image_side(const Numbers& numbers, const char* key);

// k1 k2 p1 p2, with or without k3.
Distortion distortion_of(const Numbers& numbers, const char* key);

}  // namespace augicp
