// SPDX-License-Identifier: MIT
// Shared by the tests of all readers: files as string literals, and the checks that every format must pass.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/read_cloud.h"
#include "augicp/testing/matchers.h"

namespace augicp::testing {

inline CloudFile parse(const std::string& name, std::string bytes, const ReadOptions& options = {}) {
  return parse_cloud(FileBytes{name, std::move(bytes)}, options);
}

// The message of the IoError for a file, or empty if it is read.
inline std::string refusal(const std::string& name, std::string bytes, const ReadOptions& options = {}) {
  try {
    parse(name, std::move(bytes), options);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

inline void expect_refused(const std::string& name, const std::string& bytes, std::string_view message_part) {
  EXPECT_THAT(refusal(name, bytes), ::testing::HasSubstr(message_part)) << bytes.substr(0, 300);
}

// Every proper prefix of the file gives an error or, in text, a warning.
inline void expect_cuts_are_seen(const std::string& name, const std::string& bytes) {
  ASSERT_EQ(refusal(name, bytes), "");
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    if (!refusal(name, bytes.substr(0, length)).empty()) continue;
    EXPECT_FALSE(parse(name, bytes.substr(0, length)).report.warnings.empty()) << name << " cut to " << length;
  }
}

inline std::string with(std::string text, std::string_view found, std::string_view replacement) {
  const std::size_t at = text.find(found);
  EXPECT_NE(at, std::string::npos) << found;
  return text.replace(at, found.size(), replacement);
}

inline std::string with_all(std::string text, std::string_view found, std::string_view replacement) {
  for (std::size_t at = 0; (at = text.find(found, at)) != std::string::npos; at += replacement.size())
    text.replace(at, found.size(), replacement);
  return text;
}

// Numbers as little-endian bytes.
template <typename T>
std::string packed(const std::vector<T>& values) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

// The points with their origin added.
inline std::vector<Vec3d> places(const Cloud& cloud) {
  std::vector<Vec3d> positions;
  for (const Vec3f& point : cloud.points) positions.push_back(cloud.origin + point.cast<double>());
  return positions;
}

// Three numbers per line, with all their digits.
inline std::string rows_of_three(const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += fmt::format("{}{}", values[i], i % 3 == 2 ? '\n' : ' ');
  return text;
}

// Three points a few metres apart and far from zero are read to within a micrometre. make_file takes their nine
// coordinates.
template <typename MakeFile>
void expect_far_coordinates_survive(const std::string& name, const MakeFile& make_file) {
  for (const double offset : {1e3, 1e6, 1e7}) {
    const std::vector<double> numbers{offset,       -offset,       offset + 0.125, offset + 1.1, -offset + 2.3,
                                      offset - 4.7, offset + 3.03, -offset - 1.01, offset};
    const std::vector<Vec3d> found = places(parse(name, make_file(numbers)).cloud);
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_THAT(found[i], NearVector(Vec3d(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]), 1e-6));
  }
}

}  // namespace augicp::testing
