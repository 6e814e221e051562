// SPDX-License-Identifier: MIT
#include <array>

#include "augicp/io/atomic_file.h"
#include "augicp/io/gltf_file.h"
#include "augicp/io/reader_testing.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

using ::testing::ElementsAre;
using testing::expect_refused;
using ::testing::HasSubstr;
using testing::packed;
using testing::refusal;
using testing::with;

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += at + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// The corners of a square of 2 x 2 in the plane z = 3 of its mesh, and the indices of its two faces.
const std::string kCorners = packed<float>({0, 0, 3, 2, 0, 3, 0, 2, 3, 2, 2, 3});
const std::string kIndices = packed<std::uint16_t>({0, 1, 2, 2, 1, 3});
const std::string kBuffer = kCorners + kIndices;

// The JSON of a scene with that square. node: its further members; primitive: the same of the mesh.
std::string json(const std::string& uri, const std::string& node = "",
                 const std::string& primitive = "\"indices\": 1,") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{)" + node +
         R"("mesh": 0}], "meshes": [{"primitives": [{)" + primitive + R"("attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{)" +
         uri + R"("byteLength": 60}]})";
}

std::string data_uri(const std::string& bytes = kBuffer) {
  return R"("uri": "data:application/octet-stream;base64,)" + base64(bytes) + "\", ";
}

std::string glb(std::string text, const std::string& binary = kBuffer) {
  while (text.size() % 4 != 0) text += ' ';
  const auto chunk = [](const char* kind, const std::string& content) {
    return packed<std::uint32_t>({static_cast<std::uint32_t>(content.size())}) + std::string(kind, 4) + content;
  };
  const std::string chunks = chunk("JSON", text) + (binary.empty() ? "" : chunk("BIN\0", binary));
  return "glTF" + packed<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size())}) + chunks;
}

// 1000 points on each of the two faces, evenly over the square whose corners these are, all with this normal.
void expect_square(const CloudFile& read, const Vec3f& min, const Vec3f& max, const Vec3f& normal) {
  ASSERT_EQ(read.cloud.size(), 2000u);
  const Bounds box = bounds(read.cloud);
  const Vec3f origin = read.cloud.origin.cast<float>();
  constexpr float kNear = 0.1f;  // the outermost samples keep a little away from the edges
  EXPECT_LT((origin + box.min - min).norm(), kNear * (max - min).norm());
  EXPECT_LT((origin + box.max - max).norm(), kNear * (max - min).norm());
  for (const Vec3f& direction : read.cloud.directions) ASSERT_LT((direction - normal).norm(), 1e-5f);
}

TEST(ReadGltf, BothKindsOfFileHaveTheSameFaces) {
  const testing::TemporaryFolder folder;
  write_file(folder / "a b.bin", kBuffer);
  write_file(folder / "beside.gltf", json(R"("uri": "a%20b.bin", )"));
  const CloudFile inside = testing::parse("a.gltf", json(data_uri())), binary = testing::parse("a.glb", glb(json(""))),
                  beside = read_cloud(folder / "beside.gltf");
  expect_square(inside, {0, 0, 3}, {2, 2, 3}, {0, 0, 1});
  EXPECT_EQ(inside.cloud.points, binary.cloud.points);
  EXPECT_EQ(inside.cloud.points, beside.cloud.points);
  EXPECT_EQ(inside.report.format, "gltf, 2 faces, sampled");
  EXPECT_EQ(binary.report.format, "glb, 2 faces, sampled");
}

TEST(ReadGltf, NodesMoveTheirMeshes) {
  const auto moved = [](const std::string& node) { return testing::parse("a.gltf", json(data_uri(), node)); };
  expect_square(moved(R"("translation": [10, 0, -3], "scale": [2, 1, 1], )"), {10, 0, 0}, {14, 2, 0}, {0, 0, 1});
  // A quarter turn about x: y becomes z, and z becomes -y.
  expect_square(moved(R"("rotation": [0.7071067811865476, 0, 0, 0.7071067811865476], )"), {0, -3, 0}, {2, -3, 2},
                {0, -1, 0});
  expect_square(moved(R"("matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1], )"), {5, 6, 10}, {7, 8, 10}, {0, 0, 1});
  // Mirrored, the face is still seen from above.
  expect_square(moved(R"("scale": [-1, 1, 1], )"), {-2, 0, 3}, {0, 2, 3}, {0, 0, 1});
}

TEST(ReadGltf, ChildrenMoveWithTheirParents) {
  const std::string text = with(json(data_uri()), R"("nodes": [{"mesh": 0}])",
                                R"("nodes": [{"children": [1], "scale": [2, 2, 2]},
                                             {"mesh": 0, "translation": [1, 0, -3]}])");
  expect_square(testing::parse("a.gltf", text), {2, 0, 0}, {6, 4, 0}, {0, 0, 1});
}

TEST(ReadGltf, StripsFansAndListsHaveTheSameFaces) {
  for (const char* primitive : {R"("mode": 5, )", R"("mode": 4, "indices": 1, )"})
    expect_square(testing::parse("a.gltf", json(data_uri(), "", primitive)), {0, 0, 3}, {2, 2, 3}, {0, 0, 1});
  const std::string fan = packed<float>({0, 0, 3, 2, 0, 3, 2, 2, 3, 0, 2, 3}) + kIndices;
  expect_square(testing::parse("a.gltf", json(data_uri(fan), "", R"("mode": 6, )")), {0, 0, 3}, {2, 2, 3}, {0, 0, 1});
}

TEST(ReadGltf, NumbersMayBeInterleavedAndQuantized) {
  std::string interleaved;
  for (std::size_t i = 0; i < 4; ++i) interleaved += kCorners.substr(12 * i, 12) + "skip";
  std::string text =
      with(json(data_uri(interleaved + kIndices)), R"("byteLength": 48})", R"("byteLength": 64, "byteStride": 16})");
  text = with(with(text, R"("byteOffset": 48)", R"("byteOffset": 64)"), R"("byteLength": 60)", R"("byteLength": 76)");
  expect_square(testing::parse("a.gltf", text), {0, 0, 3}, {2, 2, 3}, {0, 0, 1});
  // 65535 means 1.
  const std::string shares =
      packed<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 65535, 0, 65535, 65535, 0}) + std::string(24, '\0') + kIndices;
  text = with(json(data_uri(shares)), R"("componentType": 5126)", R"("componentType": 5123, "normalized": true)");
  expect_square(testing::parse("a.gltf", text), {0, 0, 0}, {1, 1, 0}, {0, 0, 1});
}

TEST(ReadGltf, PointsAreACloud) {
  const CloudFile read = testing::parse("a.gltf", json(data_uri(), "", R"("mode": 0, )"));
  EXPECT_EQ(read.cloud.points, (std::vector<Vec3f>{{0, 0, 3}, {2, 0, 3}, {0, 2, 3}, {2, 2, 3}}));
  EXPECT_EQ(read.report.format, "gltf points");
}

TEST(ReadGltf, WhatIsLeftOutIsSaid) {
  EXPECT_THAT(testing::parse("a.gltf", json(data_uri(), R"("skin": 0, )")).report.warnings,
              ElementsAre(HasSubstr("skin")));
  const std::string text =
      with(json(data_uri()), R"("primitives": [{)", R"("primitives": [{"mode": 1, "attributes": {"POSITION": 0}}, {)");
  EXPECT_THAT(testing::parse("a.gltf", text).report.warnings, ElementsAre("lines are not read"));
}

// Buffers that name one file, in whatever way, share its bytes.
TEST(ReadGltf, AFileOfSeveralBuffersIsReadOnce) {
  const testing::TemporaryFolder folder;
  write_file(folder / "b.bin", kBuffer);
  const std::string more = R"({"uri": "./%62.bin", "byteLength": 60}, {)";
  const std::string text = with(json(R"("uri": "b.bin", )"), "\"buffers\": [{", "\"buffers\": [" + more);
  const GltfScene scene = read_gltf_scene({folder / "a.gltf", text});
  ASSERT_EQ(scene.buffers.size(), 2u);
  EXPECT_EQ(scene.buffers[0], scene.buffers[1]);
  EXPECT_EQ(*scene.buffers[0], kBuffer);
}

// robustness 1
TEST(ReadGltf, CutsAreRefused) {
  testing::expect_cuts_are_seen("a.gltf", json(data_uri()));
  testing::expect_cuts_are_seen("a.glb", glb(json("")));
}

TEST(ReadGltf, DamageIsRefused) {
  const std::string good = json(data_uri());
  const std::array<std::string, 3> cases[] = {
      {"\"version\": \"2.0\"", "\"v\": 2", "version of glTF"},
      {"\"nodes\": [0]", "\"nodes\": [7]", "expected number 7 of \"nodes\", found 1"},
      {"\"mesh\": 0", "\"mesh\": -1", "\"mesh\" to be a whole number"},
      {"\"mesh\": 0", "\"children\": [0]", "node 0 is reached twice"},
      {"\"mesh\": 0", "\"matrix\": [1], \"mesh\": 0", "\"matrix\" with 16 numbers"},
      {"\"POSITION\": 0", "\"POSITION\": 1", "type VEC3"},
      {"\"count\": 4", "\"count\": 5", "expected 5 numbers of 12 bytes"},
      {"\"count\": 4", "\"count\": 18446744073709551615", "numbers of 12 bytes"},
      {"\"count\": 4", "\"count\": 0", "expected 0 numbers"},
      {"\"count\": 4", "\"count\": 3", "expected a vertex below 3, found 3"},
      {"\"bufferView\": 0, ", "", "sparse"},
      {"5126", "5124", "component type"},
      {"5123", "5122", "unsigned component type"},
      {"\"buffer\": 0, \"byteLength\": 48", "\"buffer\": 3, \"byteLength\": 48", "expected a buffer 3"},
      {"\"byteLength\": 60", "\"byteLength\": 61", "expected a buffer of 61 bytes, found 60"},
      {"base64,", "base64,*", "base64"},
      {"\"scene\": 0", "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]", "expected plain meshes"},
      {"\"indices\"", "\"mode\": 9, \"indices\"", "mode from 0 to 6"}};
  for (const auto& [found, replacement, message] : cases)
    expect_refused("a.gltf", with(good, found, replacement), message);
  expect_refused("a.gltf", "[1]", "expected glTF");
  expect_refused("a.gltf", json(R"("uri": "../secret.bin", )"), "beside the file");
  expect_refused("a.gltf", json(R"("uri": "https://a/b.bin", )"), "beside the file");
  expect_refused("a.gltf", json(R"("uri": "/etc/hostname", )"), "beside the file");
  expect_refused("a.gltf", json(R"("uri": "missing.bin", )"),
                 "a.gltf: its buffer cannot be read: missing.bin: no such file");
  expect_refused("a.gltf", json(""), "with a \"uri\"");
  std::string old = glb(json(""));
  old[4] = 1;
  expect_refused("a.glb", old, "version 2 of glTF, found 1");
}

std::string repeated(const std::string& text, int count) {
  std::string all = text;
  for (int i = 1; i < count; ++i) all += ", " + text;
  return all;
}

// 2000 nodes that each show a mesh of 1000 primitives: a small file that would fill the memory.
TEST(ReadGltf, NodesTimesPrimitivesAreLimited) {
  std::string text = with(json(data_uri()), R"("scene": 0, "scenes": [{"nodes": [0]}], )", "");  // all are shown
  text = with(text, R"({"mesh": 0})", repeated(R"({"mesh": 0})", 2000));
  const std::string primitive = R"({"indices": 1,"attributes": {"POSITION": 0}})";
  expect_refused("a.gltf", with(text, primitive, repeated(primitive, 1000)), "at most 1048576 primitives");
}

}  // namespace
}  // namespace augicp
