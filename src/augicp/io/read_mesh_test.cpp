// SPDX-License-Identifier: MIT
#include "augicp/io/read_mesh.h"

#include "augicp/io/mesh_samples.h"
#include "augicp/io/reader_testing.h"

namespace augicp {
namespace {

using ::testing::HasSubstr;
using testing::packed;
using testing::parse;

// A box of 1 x 2 x 3 m as an OBJ file: six polygons of four corners, seen counterclockwise from outside.
std::string box_obj(const std::string& offset = "") {
  std::string text = "# a box\no box\n";
  for (const char* corner : {"0 0 0", "1 0 0", "1 2 0", "0 2 0", "0 0 3", "1 0 3", "1 2 3", "0 2 3"})
    text += std::string("v ") + offset + corner + "\n";
  return text +
         "vn 0 0 1\nf 4 3 2 1\nf 5//1 6//1 7//1 8//1\nf 1 2 6 5\nf 3/1/1 4/1/1 8/1/1 7/1/1\nf -8 -4 -1 -5\nf 2 3 7 6\n";
}

// The same faces as triangles.
std::vector<Triangle> box_faces() {
  const Vec3d corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}};
  const int polygons[][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}};
  std::vector<Triangle> faces;
  for (const auto& [a, b, c, d] : polygons) {
    faces.push_back({corners[a], corners[b], corners[c]});
    faces.push_back({corners[a], corners[c], corners[d]});
  }
  return faces;
}

std::string box_stl(bool is_binary) {
  std::string text = is_binary ? std::string(80, ' ') + packed<std::uint32_t>({12}) : "solid box\n";
  for (const Triangle& face : box_faces()) {
    text += is_binary ? std::string(12, '\0') : "facet normal 0 0 0\n outer loop\n";
    for (const Vec3d& p : face)
      text += is_binary ? packed<float>({float(p.x()), float(p.y()), float(p.z())})
                        : fmt::format("  vertex {} {} {}\n", p.x(), p.y(), p.z());
    text += is_binary ? std::string(2, '\0') : " endloop\nendfacet\n";
  }
  return is_binary ? text : text + "endsolid box\n";
}

// The box as a PLY file: polygons of four corners behind a flag, and an element that nobody needs between.
std::string box_ply(const std::string& encoding) {
  const bool is_text = encoding == "ascii", is_big = encoding == "binary_big_endian";
  const auto bytes_of = [&](auto value) {
    if (is_text) return fmt::format("{} ", value);
    std::string bytes = packed<decltype(value)>({value});
    if (is_big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  const std::string end = is_text ? "\n" : "";
  std::string text =
      "ply\nformat " + encoding +
      " 1.0\nelement vertex 8\nproperty float x\nproperty uchar flag\nproperty float y\nproperty double "
      "z\nelement other 1\nproperty list ushort short some\nelement face 6\nproperty uchar flag\nproperty "
      "list uint int vertex_indices\nend_header\n";
  for (const auto& [x, y, z] : std::vector<std::array<int, 3>>{
           {0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 3}, {1, 2, 3}, {0, 2, 3}})
    text += bytes_of(float(x)) + bytes_of(std::uint8_t{7}) + bytes_of(float(y)) + bytes_of(double(z)) + end;
  text += bytes_of(std::uint16_t{2}) + bytes_of(std::int16_t{5}) + bytes_of(std::int16_t{6}) + end;
  for (const auto& polygon : std::vector<std::array<int, 4>>{
           {3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}}) {
    text += bytes_of(std::uint8_t{1}) + bytes_of(std::uint32_t{4});
    for (const int corner : polygon) text += bytes_of(std::int32_t{corner});
    text += end;
  }
  return text;
}

const ReadOptions kSampled{.sample_faces = true};

// Every point is on the face of its normal, which points outwards, and faces have points by their area.
void expect_the_box(const std::string& name, const std::string& bytes) {
  SCOPED_TRACE(name);
  const CloudFile file = parse_cloud({name, bytes}, kSampled);
  const Vec3f size(1, 2, 3);
  ASSERT_EQ(file.cloud.size(), 12000u);
  std::array<int, 6> num_on{};
  for (std::size_t i = 0; i < file.cloud.size(); ++i) {
    const Vec3f &p = file.cloud.points[i], &n = file.cloud.directions[i];
    int axis = 0;
    ASSERT_NEAR(n.cwiseAbs().maxCoeff(&axis), 1.0f, 1e-6f);
    ASSERT_NEAR(p[axis], n[axis] > 0.0f ? size[axis] : 0.0f, 1e-6f);
    ASSERT_TRUE((p.array() >= -1e-6f).all() && (p.array() <= size.array() + 1e-6f).all());
    ++num_on[static_cast<std::size_t>(2 * axis + (n[axis] > 0.0f))];
  }
  const double areas[] = {6, 6, 3, 3, 2, 2};
  for (std::size_t side = 0; side < 6; ++side) EXPECT_NEAR(num_on[side], 12000 * areas[side] / 22, 1.5) << side;
}

TEST(ReadMesh, PointsLieOnTheirFacesEvenly) {
  expect_the_box("a.obj", box_obj());
  expect_the_box("a.stl", box_stl(true));
  expect_the_box("a.STL", box_stl(false));
}

// The mean and the covariance of a uniform distribution on a triangle: (a + b + c) / 3, and the sum of squares of the
// corners around it over 12.
TEST(ReadMesh, FacesOfPlyAreSampledOnDemand) {
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string ply = box_ply(encoding);
    expect_the_box("a.ply", ply);
    EXPECT_EQ(parse("a.ply", ply).cloud.size(), 8u);
    for (std::size_t length = ply.find("end_header"); length + 2 < ply.size(); length += 3)
      EXPECT_THROW(parse_cloud({"a.ply", ply.substr(0, length)}, kSampled), IoError) << encoding << " " << length;
  }
  const std::string text = box_ply("ascii");
  EXPECT_THROW(parse_cloud({"a.ply", testing::with(text, "1 4 2 3 7 6", "1 4 2 3 8 6")}, kSampled), IoError);
  EXPECT_THROW(parse_cloud({"a.ply", testing::with(text, "1 4 2 3 7 6", "1 4 2 3 -1 6")}, kSampled), IoError);
  EXPECT_EQ(parse_cloud({"a.ply", testing::with(text, "face 6", "face 0")}, kSampled).cloud.size(), 8u);
}

TEST(ReadMesh, AFaceIsCoveredEvenly) {
  const Cloud cloud = parse("a.obj", "v 0 0 0\nv 4 0 0\nv 0 2 0\nf 1 2 3\n").cloud;
  Vec3d mean = Vec3d::Zero(), square = Vec3d::Zero();
  for (const Vec3f& p : cloud.points) mean += p.cast<double>() / static_cast<double>(cloud.size());
  for (const Vec3f& p : cloud.points)
    square += (p.cast<double>() - mean).cwiseAbs2() / static_cast<double>(cloud.size());
  EXPECT_THAT(mean, testing::NearVector(Vec3d(4.0 / 3, 2.0 / 3, 0), 0.02));
  EXPECT_THAT(square, testing::NearVector(Vec3d(16.0 / 18, 4.0 / 18, 0), 0.02));
}

TEST(ReadMesh, FarMeshesLoseNothing) {
  const CloudFile file = parse("a.obj", box_obj("400000"));  // x is 4000000 and 4000001
  float least = 1e30f, most = -1e30f;
  for (const Vec3f& p : file.cloud.points) {
    least = std::min(least, p.x());
    most = std::max(most, p.x());
  }
  EXPECT_NEAR(most - least, 1.0f, 1e-6f);
}

TEST(ReadMesh, AnObjWithoutFacesIsItsVertices) {
  EXPECT_EQ(parse("a.obj", "v 1 2 3\nv 4 5 6\n").cloud.points, (std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}}));
}

// robustness 1
TEST(ReadMesh, CutsAreSeen) {
  testing::expect_cuts_are_seen(
      "a.stl", box_stl(true).substr(0, 80) + packed<std::uint32_t>({2}) + box_stl(true).substr(84, 100));
  const std::string one =
      "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "a";
  for (std::size_t length = 0; length < one.find("endsolid") + 8; ++length)
    EXPECT_NE(testing::refusal("a.stl", one.substr(0, length)), "") << length;
  EXPECT_THAT(parse("a.obj", box_obj().substr(0, box_obj().size() - 1)).report.warnings[0], HasSubstr("no end"));
}

TEST(ReadMesh, WhatIsNoMeshIsRefused) {
  const auto refused = [](const char* name, const std::string& bytes, std::string_view what) {
    testing::expect_refused(name, bytes, what);
  };
  refused("a.obj", "v 0 0 0\nf 1 2 3\n", "line 2: expected a corner among the 1 vertices");
  refused("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "three corners");
  refused("a.obj", "v 0 0\n", "line 1: expected 'v x y z'");
  refused("a.obj", "v 0 0 nan\n", "finite");
  refused("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "none of its 1 faces has an area");
  refused("a.obj", "# nothing\n", "holds no points");
  refused("a.stl", std::string(80, ' ') + packed<std::uint32_t>({0}), "holds no faces");
  refused("a.stl", std::string(80, ' ') + packed<std::uint32_t>({1}) + std::string(50, '\xff'), "face 1 is not finite");
  refused("a.stl", std::string(80, ' ') + packed<std::uint32_t>({2}) + std::string(50, '\0'),
          "expected 184 bytes of 2 faces");
  EXPECT_NE(testing::refusal("a.obj", box_obj(), {.max_points = 11999}), "");
}

}  // namespace
}  // namespace augicp
