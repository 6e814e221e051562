// SPDX-License-Identifier: MIT
// Columns beside the cloud's own on their way from a reader to a writer.
#include "augicp/io/point_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "augicp/io/reader_testing.h"
#include "augicp/io/write_cloud.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using testing::parse;
using testing::with;

const ReadOptions kKeep{.keep_fields = true};

// Columns of every type, at the ends of their ranges; one of several numbers.
PointFields fields_of_all_types(std::size_t num_rows) {
  PointFields all;
  for (int type = 0; type <= static_cast<int>(ScalarType::Float64); ++type) {
    PointField field{"column" + std::to_string(type), static_cast<ScalarType>(type), type == 3 ? 2u : 1u, {}};
    with_type(field.type, [&](auto zero) {
      using Limits = std::numeric_limits<decltype(zero)>;
      for (std::size_t i = 0; i < num_rows * field.count; ++i) {
        const decltype(zero) value = i % 3 == 0 ? Limits::lowest() : i % 3 == 1 ? Limits::max() : decltype(zero)(i);
        field.values.append(reinterpret_cast<const char*>(&value), sizeof(value));
      }
    });
    all.fields.push_back(std::move(field));
  }
  return all;
}

CloudFile file_with(PointFields fields, std::size_t num_points) {
  CloudFile file;
  for (std::size_t i = 0; i < num_points; ++i) file.cloud.points.push_back(Vec3f(float(i), 1, float(i * i)));
  file.fields = std::move(fields);
  return file;
}

void expect_equal(const PointField& found, const PointField& expected) {
  EXPECT_EQ(found.name, expected.name);
  EXPECT_EQ(found.type, expected.type) << found.name;
  EXPECT_EQ(found.count, expected.count) << found.name;
  EXPECT_EQ(found.values, expected.values) << found.name;
}

TEST(PointFields, PcdKeepsEveryTypeAndCount) {
  const testing::TemporaryFolder folder;
  const CloudFile file = file_with(fields_of_all_types(10), 10);
  EXPECT_THAT(write_cloud(folder / "a.pcd", file), IsEmpty());
  const CloudFile found = read_cloud(folder / "a.pcd", kKeep);
  ASSERT_EQ(found.fields.fields.size(), file.fields.fields.size());
  for (std::size_t i = 0; i < file.fields.fields.size(); ++i)
    expect_equal(found.fields.fields[i], file.fields.fields[i]);
  write_cloud(folder / "b.pcd", found);
  EXPECT_EQ(read_bytes(folder / "b.pcd").bytes, read_bytes(folder / "a.pcd").bytes);
  EXPECT_THAT(read_cloud(folder / "a.pcd").fields.fields, IsEmpty()) << "only where they are asked for";
}

TEST(PointFields, PlySplitsWhatItHasNoPlaceFor) {
  const testing::TemporaryFolder folder;
  const std::vector<std::string> notes = write_cloud(folder / "a.ply", file_with(fields_of_all_types(10), 10));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("column6"), HasSubstr("column7")));
  const CloudFile found = read_cloud(folder / "a.ply", kKeep);
  std::vector<std::string> names;
  for (const PointField& field : found.fields.fields) names.push_back(field.name);
  EXPECT_THAT(names, ElementsAre("column0", "column1", "column2", "column3_0", "column3_1", "column4", "column5",
                                 "column6", "column7", "column8", "column9"));
  const PointField whole = fields_of_all_types(10).fields[3];
  for (std::size_t row = 0; row < 10; ++row)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(found.fields.fields[3 + k].at(row), whole.at(row, k));
  write_cloud(folder / "b.ply", found);
  EXPECT_EQ(read_bytes(folder / "b.ply").bytes, read_bytes(folder / "a.ply").bytes);
}

TEST(PointFields, ColoursSurvivePackedAndUnpacked) {
  const testing::TemporaryFolder folder;
  const std::vector<Colour> colours{{255, 0, 1}, {2, 3, 254}};
  CloudFile file = file_with({colour_fields(colours), {}}, 2);
  write_cloud(folder / "a.pcd", file);
  const CloudFile packed = read_cloud(folder / "a.pcd", kKeep);
  ASSERT_EQ(packed.fields.fields.size(), 1u);
  EXPECT_EQ(packed.fields.fields[0].name, "rgb");
  EXPECT_EQ(packed.fields.fields[0].values.substr(0, 4), std::string("\x01\x00\xff\x00", 4)) << "0x00rrggbb";
  write_cloud(folder / "b.ply", packed);
  const CloudFile found = read_cloud(folder / "b.ply", kKeep);
  for (std::size_t i = 0; i < 3; ++i) expect_equal(found.fields.fields[i], file.fields.fields[i]);
}

TEST(PointFields, TextHasTheSmallestTypeOfItsNumbers) {
  const CloudFile file = parse("a.csv",
                               "x,y,z,r,ring,t_ns,stamp,label,neg\n"
                               "0,0,0,255,1000,1700000000123456789,0.5,tree,-1\n"
                               "1,0,0,7,70000,1700000000123456790,1,wall,-200\n",
                               kKeep);
  const std::vector<PointField>& fields = file.fields.fields;
  ASSERT_EQ(fields.size(), 5u);
  using enum ScalarType;
  const ScalarType expected[] = {Uint8, Int32, Int64, Float64, Int16};
  for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_EQ(fields[i].type, expected[i]) << fields[i].name;
  EXPECT_NE(fields[2].values.substr(0, 8), fields[2].values.substr(8)) << "all digits of a stamp";
  EXPECT_EQ(fields[3].at(1), 1.0);
  EXPECT_THAT(file.fields.not_kept, ElementsAre(HasSubstr("'label' has 'tree' in line 2")));
}

TEST(PointFields, TextWithoutNamesHasNumbers) {
  const CloudFile file = parse("a.xyz", "0 0 0 1 2\n1 1 1 3\n", kKeep);
  ASSERT_EQ(file.fields.fields.size(), 2u);
  EXPECT_EQ(file.fields.fields[0].name, "column_4");
  EXPECT_TRUE(std::isnan(file.fields.fields[1].at(1))) << "missing in its line";
}

// Points that are dropped take their numbers with them, also if the cloud is read twice for its origin.
TEST(PointFields, FieldsFollowTheirPoints) {
  for (const char* far : {"", "4000000"}) {
    const CloudFile file = parse("a.xyz", fmt::format("{0}1 0 0 1\nnan 0 0 2\n{0}3 0 0 3\n{0}4 0 0 4\n", far), kKeep);
    ASSERT_EQ(file.fields.fields.size(), 1u);
    ASSERT_EQ(file.fields.fields[0].num_rows(), 3u);
    EXPECT_EQ(file.fields.fields[0].at(1), 3.0);
  }
}

TEST(PointFields, AGridKeepsItsCells) {
  const testing::TemporaryFolder folder;
  const std::string organised =
      "VERSION 0.7\nFIELDS x y z ring\nSIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 3\nHEIGHT 2\nDATA ascii\n"
      "0 0 0 10\nnan nan nan 11\n2 0 1 12\n3 0 0 13\n4 1 0 14\nnan 0 0 15\n";
  const CloudFile file = parse("a.pcd", organised, kKeep);
  EXPECT_THAT(write_cloud(folder / "a.pcd", file), IsEmpty());
  const CloudFile found = read_cloud(folder / "a.pcd", kKeep);
  ASSERT_TRUE(found.grid);
  EXPECT_EQ(found.grid->index, file.grid->index);
  EXPECT_EQ(found.grid->width, 3);
  EXPECT_EQ(found.cloud.points, file.cloud.points);
  expect_equal(found.fields.fields[0], file.fields.fields[0]);

  EXPECT_THAT(write_cloud(folder / "a.ply", file), ElementsAre(HasSubstr("grid of 3 x 2")));
  const CloudFile ply = read_cloud(folder / "a.ply", kKeep);
  EXPECT_EQ(ply.report.num_declared, 4u);
  EXPECT_EQ(ply.fields.fields[0].at(1), 12.0);
}

// An aligned cloud has an origin, but near zero float is enough for it.
TEST(PointFields, PositionsStayFloatUnlessTheyNeedMore) {
  const testing::TemporaryFolder folder;
  for (const double shift : {0.25, 1e6}) {
    CloudFile file = file_with({}, 20);
    file.cloud.origin = Vec3d(shift, 0, 0);
    write_cloud(folder / "a.ply", file);
    EXPECT_THAT(read_bytes(folder / "a.ply").bytes, HasSubstr(shift < 1.0 ? "property float x" : "property double x"));
  }
}

TEST(PointFields, NamesAreWordsAndUnique) {
  const testing::TemporaryFolder folder;
  const CloudFile file = parse("a.csv", "x,y,z,Scan Angle,scan_angle,nx\n0,0,0,1,2,3\n1,0,0,1,2,3\n", kKeep);
  for (const char* name : {"a.ply", "a.pcd"}) {
    write_cloud(folder / name, file);
    const CloudFile found = read_cloud(folder / name, kKeep);
    ASSERT_EQ(found.fields.fields.size(), 3u) << name;
    EXPECT_EQ(found.fields.fields[0].name, "Scan_Angle");
    EXPECT_EQ(found.fields.fields[1].name, "scan_angle_2");
    EXPECT_EQ(found.fields.fields[2].name, "nx_2");
    EXPECT_EQ(found.fields.fields[2].at(0), 3.0);
  }
}

TEST(PointFields, WhatPlyHasBesidePointsIsNamed) {
  const CloudFile file = parse("a.ply",
                               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
                               "float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\n"
                               "end_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n",
                               kKeep);
  EXPECT_THAT(file.fields.not_kept, ElementsAre("the 1 records of element 'face'"));
  EXPECT_EQ(file.fields.fields[0].at(2), 3.0);
}

TEST(PointFields, TangentsHaveColumnsOfTheirOwn) {
  const testing::TemporaryFolder folder;
  CloudFile file = file_with({}, 3);
  file.cloud.directions = {{0, 0, 1}, {1, 0, 0}, {0, 0, 0}};
  file.cloud.structures = {Structure::Planar, Structure::Edge, Structure::None};
  for (const char* name : {"a.ply", "a.pcd"}) {
    write_cloud(folder / name, file);
    EXPECT_THAT(read_bytes(folder / name).bytes, HasSubstr("tangent_x"));
    const CloudFile found = read_cloud(folder / name, kKeep);
    EXPECT_EQ(found.cloud.directions, file.cloud.directions);
    EXPECT_EQ(found.cloud.structures, file.cloud.structures);
    EXPECT_THAT(found.fields.fields, IsEmpty());
  }
  const std::string normals_alone = with(read_bytes(folder / "a.ply").bytes, "structure", "strvcture");
  EXPECT_EQ(parse("b.ply", normals_alone).cloud.directions[1], Vec3f(Vec3f::Zero())) << "no tangent among the normals";
}

TEST(PointFields, NormalsThatAreAllZeroAreNone) {
  const CloudFile file = parse("a.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,0\n1,0,0,0,0,0\n0,1,0,0,0,0\n");
  EXPECT_FALSE(file.cloud.has_directions());
  EXPECT_FALSE(file.report.has_normals);
  EXPECT_THAT(file.report.warnings, ElementsAre(HasSubstr("no normal")));
  EXPECT_TRUE(parse("a.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,0\n1,0,0,0,0,2\n").cloud.has_directions());
}

TEST(PointFields, RowsMustFit) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(write_cloud(folder / "a.ply", file_with(fields_of_all_types(3), 4)), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace augicp
