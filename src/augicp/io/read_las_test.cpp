// SPDX-License-Identifier: MIT
#include "augicp/io/read_las.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "augicp/io/las_format.h"
#include "augicp/io/reader_testing.h"
#include "augicp/io/write_cloud.h"
#include "augicp/io/write_las.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using las::number_at;
using las::set_number;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::parse;
using testing::refusal;

const ReadOptions kKeepLasFields{.keep_fields = true};
constexpr std::size_t kExtra = 3;  // bytes a record that nothing describes

// Three points of a version and a point format, every byte of each record another; one variable length record.
std::string las_file(int minor_version, int point_format) {
  const std::size_t header = las::kHeaderSizes[minor_version], length = las::kRecordSizes[point_format] + kExtra;
  std::string bytes(header + las::kVlrHeader + 5, '\0');
  bytes.replace(0, 4, "LASF");
  bytes[24] = 1;
  bytes[25] = static_cast<char>(minor_version);
  set_number(bytes, las::kHeaderSize, static_cast<std::uint16_t>(header));
  set_number(bytes, las::kPointsOffset, static_cast<std::uint32_t>(bytes.size()));
  set_number<std::uint32_t>(bytes, las::kNumVlrs, 1);
  bytes[las::kPointFormat] = static_cast<char>(point_format);
  set_number(bytes, las::kRecordLength, static_cast<std::uint16_t>(length));
  set_number<std::uint32_t>(bytes, las::kLegacyNumPoints, 3);
  if (minor_version == 4) set_number<std::uint64_t>(bytes, las::kNumPoints, 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    set_number(bytes, las::kScale + 8 * axis, 0.01);
    set_number(bytes, las::kOffset + 8 * axis, 1e6 * double(axis));
  }
  bytes.replace(header + 2, 5, "abcde");
  set_number<std::uint16_t>(bytes, header + 20, 5);
  bytes.replace(header + las::kVlrHeader, 5, "12345");
  for (std::int32_t i = 0; i < 3; ++i) {
    std::string record(length, '\0');
    for (std::size_t k = 0; k < length; ++k) record[k] = static_cast<char>(17 * k + 31 * i + 5);
    for (std::size_t axis = 0; axis < 3; ++axis) set_number<std::int32_t>(record, 4 * axis, 100 * i * i + int(axis));
    set_number<std::uint16_t>(record, 12, static_cast<std::uint16_t>(7 * i));
    bytes += record;
  }
  return bytes;
}

template <typename Check>
void for_each_kind(const Check& check) {
  for (int minor_version = 0; minor_version <= 4; ++minor_version)
    for (int point_format = 0; point_format < las::kNumFormats; ++point_format) {
      SCOPED_TRACE(fmt::format("1.{} format {}", minor_version, point_format));
      check(las_file(minor_version, point_format), point_format);
    }
}

TEST(ReadLas, EveryVersionAndFormatHasPositionsAndIntensities) {
  for_each_kind([](const std::string& bytes, int) {
    const CloudFile file = parse("a.las", bytes);
    const std::vector<Vec3d> places = testing::places(file.cloud);
    ASSERT_EQ(places.size(), 3u);
    EXPECT_THAT(places[2], testing::NearVector(Vec3d(4.0, 1e6 + 4.01, 2e6 + 4.02), 1e-6));
    EXPECT_THAT(file.cloud.intensities, ElementsAre(0.0f, 7.0f, 14.0f));
    EXPECT_THAT(file.report.warnings, IsEmpty());
  });
}

// robustness 1
TEST(ReadLas, CutsAreRefused) {
  for_each_kind([](const std::string& bytes, int) { testing::expect_cuts_are_seen("a.las", bytes); });
}

// robustness 6: nothing but the bounds changes where nothing is moved.
TEST(ReadLas, WriteThenReadIsIdentity) {
  const testing::TemporaryFolder folder;
  for_each_kind([&](const std::string& bytes, int point_format) {
    const CloudFile file = parse("a.las", bytes + "tail", kKeepLasFields);
    const std::vector<std::string> notes = write_cloud(folder / "b.las", file);
    EXPECT_EQ(notes.size(), las::has_waveform(point_format) ? 1u : 0u);
    std::string found = read_bytes(folder / "b.las").bytes, expected = bytes + "tail";
    EXPECT_EQ(number_at<double>(found, las::kBounds), 4.0) << "the largest x";
    EXPECT_EQ(number_at<double>(found, las::kBounds + 24), 1e6 + 0.01) << "the least y";
    EXPECT_EQ(found.replace(las::kBounds, 48, ""), expected.replace(las::kBounds, 48, ""));
  });
}

TEST(ReadLas, AMovedFileHasMovedPointsAndAllElse) {
  const testing::TemporaryFolder folder;
  CloudFile file = parse("a.las", las_file(2, 3), kKeepLasFields);
  for (const Vec3d& shift : {Vec3d(10, -20, 3), Vec3d(1e8, 0, 0)}) {  // the second needs another offset
    CloudFile moved = file;
    moved.cloud.origin += shift;
    write_cloud(folder / "b.las", moved);
    const CloudFile found = read_cloud(folder / "b.las", kKeepLasFields);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_THAT(testing::places(found.cloud)[i], testing::NearVector(testing::places(file.cloud)[i] + shift, 0.006));
    const PointFields before = fields_of(*file.las), after = fields_of(*found.las);
    for (std::size_t i = 0; i < before.fields.size(); ++i)
      EXPECT_EQ(before.fields[i].values, after.fields[i].values) << before.fields[i].name;
  }
}

// Bits by hand: 0b10'110'101 is return 5 of 6, along the scan's direction and at no edge... by the specification's
// tables 4 and 16.
TEST(ReadLas, BitsAreUnpacked) {
  std::string bytes = las_file(2, 0);
  const std::size_t first = bytes.size() - 3 * (20 + kExtra);
  bytes[first + 14] = char(0b01'110'101);
  bytes[first + 15] = char(0b101'00110);
  PointFields fields = fields_of(*parse("a.las", bytes, kKeepLasFields).las);
  const auto value = [&](const char* name) { return fields.find(name)->at(0); };
  EXPECT_EQ(value("return_number"), 5.0);
  EXPECT_EQ(value("number_of_returns"), 6.0);
  EXPECT_EQ(value("scan_direction_flag"), 1.0);
  EXPECT_EQ(value("edge_of_flight_line"), 0.0);
  EXPECT_EQ(value("classification"), 6.0);
  EXPECT_EQ(value("synthetic"), 1.0);
  EXPECT_EQ(value("key_point"), 0.0);
  EXPECT_EQ(value("withheld"), 1.0);
  EXPECT_EQ(fields.find("extra_bytes")->count, kExtra);

  bytes = las_file(4, 6);
  const std::size_t extended = bytes.size() - 3 * (30 + kExtra);
  bytes[extended + 14] = char(0b1011'1010);
  bytes[extended + 15] = char(0b01'10'1001);
  fields = fields_of(*parse("a.las", bytes, kKeepLasFields).las);
  EXPECT_EQ(value("return_number"), 10.0);
  EXPECT_EQ(value("number_of_returns"), 11.0);
  EXPECT_EQ(value("synthetic"), 1.0);
  EXPECT_EQ(value("overlap"), 1.0);
  EXPECT_EQ(value("scanner_channel"), 2.0);
  EXPECT_EQ(value("scan_direction_flag"), 1.0);
}

// robustness 3
TEST(ReadLas, WhatDoesNotFitIsRefused) {
  const auto expect_refused = [](std::string bytes, std::string_view what) {
    testing::expect_refused("a.las", bytes, what);
  };
  const std::string good = las_file(4, 7);
  const auto changed = [&](std::size_t at, auto value) {
    std::string bytes = good;
    set_number(bytes, at, value);
    return bytes;
  };
  expect_refused("LASX" + good.substr(4), "'LASF'");
  expect_refused(changed(25, char(5)), "version");
  expect_refused(changed(las::kPointFormat, char(0x80 | 7)), "LAZ");
  expect_refused(changed(las::kPointFormat, char(11)), "point format");
  expect_refused(changed(las::kRecordLength, std::uint16_t{35}), "at least 36");
  expect_refused(changed(las::kHeaderSize, std::uint16_t{227}), "at least 375");
  expect_refused(changed(las::kPointsOffset, std::uint32_t{100}), "behind the header");
  expect_refused(changed(las::kNumPoints, std::uint64_t{1} << 60), "twice");
  expect_refused(changed(las::kNumVlrs, std::uint32_t{2}), "variable length record");
  expect_refused(changed(las::kScale, 0.0), "scale");
  expect_refused(changed(las::kOffset, std::numeric_limits<double>::quiet_NaN()), "offset");
  expect_refused(changed(las::kNumEvlrs, std::uint32_t{1}), "behind the points");
}

// robustness 2
TEST(ReadLas, CountsAreBelievedAsFarAsTheBytesGo) {
  std::string bytes = las_file(4, 6);
  set_number<std::uint32_t>(bytes, las::kLegacyNumPoints, 0);
  set_number(bytes, las::kNumPoints, std::uint64_t{1} << 60);
  testing::expect_refused("a.las", bytes, "the file ends here");
  EXPECT_THAT(refusal("a.las", las_file(2, 0), {.max_points = 2}), HasSubstr("at most 2 points"));
  EXPECT_THAT(parse("a.las", las_file(2, 0) + "more").report.warnings, ElementsAre(HasSubstr("4 bytes after")));
}

TEST(WriteLas, AnyCloudBecomesLas) {
  const testing::TemporaryFolder folder;
  const CloudFile file = parse("a.csv",
                               "x,y,z,nx,ny,nz,red,green,blue,intensity,classification,ring,stamp\n"
                               "1e6,0,0,0,0,1,255,0,1,300,5,70000,0.125\n1e6,100,0,0,0,1,2,3,4,1,6,1,0."
                               "5\n",
                               kKeepLasFields);
  EXPECT_THAT(write_cloud(folder / "a.las", file), IsEmpty());
  const CloudFile found = read_cloud(folder / "a.las", kKeepLasFields);
  EXPECT_EQ(found.report.format, "las 1.4 point format 7");
  EXPECT_THAT(testing::places(found.cloud)[1], testing::NearVector(Vec3d(1e6, 100, 0), 1e-6));
  const PointFields fields = fields_of(*found.las);
  const std::pair<const char*, double> expected[] = {
      {"red", 65535},  {"green", 0},     {"blue", 257}, {"intensity", 300}, {"classification", 5},
      {"ring", 70000}, {"stamp", 0.125}, {"nz", 1},     {"structure", 1},   {"return_number", 1}};
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(fields.find(name)) << name;
    EXPECT_EQ(fields.find(name)->at(0), value) << name;
  }
}

TEST(ReadLas, FieldsReachOtherFormats) {
  const testing::TemporaryFolder folder;
  const std::vector<std::string> notes = write_cloud(folder / "a.ply", parse("a.las", las_file(3, 5), kKeepLasFields));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("variable length"), HasSubstr("waveforms")));
  const PointFields fields = read_cloud(folder / "a.ply", kKeepLasFields).fields;
  EXPECT_EQ(fields.find("intensity")->at(2), 14.0);
  EXPECT_EQ(fields.find("gps_time")->type, ScalarType::Float64);
  EXPECT_EQ(fields.find("red")->type, ScalarType::Uint16);
}

// Files of other programs, where they are.
TEST(ReadLas, PublicFilesSurviveByteByByte) {
  const std::filesystem::path shared = std::filesystem::path(AUGICP_SHARED_DATA_DIR) / "formats/las";
  if (!std::filesystem::is_directory(shared)) GTEST_SKIP() << "no folder " << shared;
  const testing::TemporaryFolder folder;
  const std::pair<const char*, std::size_t> files[] = {
      {"extrabytes.las", 1065}, {"simple1_4.las", 0}, {"vegetation_1_3.las", 0}};
  for (const auto& [name, num_points] : files) {
    SCOPED_TRACE(name);
    const CloudFile file = read_cloud(shared / name, kKeepLasFields);
    if (num_points > 0) {
      EXPECT_EQ(file.cloud.size(), num_points);
    }
    EXPECT_THAT(file.report.warnings, IsEmpty());
    write_cloud(folder / name, file);
    std::string found = read_bytes(folder / name).bytes, expected = read_bytes(shared / name).bytes;
    EXPECT_TRUE(found.replace(las::kBounds, 48, "") == expected.replace(las::kBounds, 48, ""));
  }
  EXPECT_THROW(read_cloud(shared / "autzen_trim.laz"), IoError);
}

}  // namespace
}  // namespace augicp
