// SPDX-License-Identifier: MIT
// Odd and malformed files that other projects collected, and what each must give. They are not part of this project:
// the folder is AUGICP_SHARED_DATA in the environment, or what the build was told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "augicp/io/read_cloud.h"

namespace augicp {
namespace {

struct OddFile {
  const char* name;
  std::size_t num_points;  // 0: an error
  const char* says;        // a part of the error or of a warning; or empty
};

constexpr OddFile kOddFiles[] = {
    {"assimp/crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", 0, "line 7"},
    {"assimp/cube.ply", 8, ""},
    {"assimp/cube_binary.ply", 8, ""},
    {"assimp/cube_binary_header_with_RN_newline.ply", 8, ""},
    {"assimp/cube_binary_starts_with_nl.ply", 8, ""},
    {"assimp/cube_uv.ply", 24, ""},
    {"assimp/empty.ply", 0, "the file ends before"},
    {"assimp/float-color.ply", 3, ""},
    {"assimp/issue623.ply", 0, "found the list 'vertex_indices'"},
    {"assimp/points.ply", 4, ""},
    {"happly/platonic_shelf.ply", 50, ""},
    {"happly/platonic_shelf_ascii.ply", 50, ""},
    {"happly/platonic_shelf_big_endian.ply", 50, ""},
    {"open3d/bathtub_0154.ply", 1494, ""},
    {"open3d/input.ply", 3, "lines after the declared elements"},
    {"open3d/knot.ply", 1440, ""},
    {"open3d/simple.xyz", 4, ""},
    {"open3d/sphere.ply", 642, ""},
    {"open3d/test_sample_ascii.ply", 7, ""},
    {"open3d/test_sample_custom.ply", 7, ""},
    {"open3d/test_sample_wrong_format.ply", 2, ""},
    {"pcl/bunny.pcd", 397, ""},
    {"pcl/car6.pcd", 10031, ""},
    {"pcl/colored_cloud.pcd", 1000, ""},
    {"pcl/cube.ply", 24, ""},
    {"pcl/curve2d.pcd", 51, ""},
    {"pcl/nhood_test.pcd", 36, "the last line has no end"},
    {"pcl/octants.pcd", 8, ""},
    {"pcl/pcl_logo.pcd", 12909, ""},
    {"pdal/autzen-utm.pcd", 1065, ""},
    {"pdal/autzen.pts", 10, ""},
    {"pdal/bunny_8.pts", 8, "lines after the declared points"},
    {"pdal/issue_2421.ply", 1, ""},
    {"pdal/mesh.ply", 4, ""},
    {"pdal/mesh_fixed.ply", 4, ""},
    {"pdal/missingheader.pcd", 0, "line 1: expected a keyword of a PCD header"},
    {"pdal/no_vertex.ply", 0, "expected an element 'vertex', found none"},
    {"pdal/simple_binary.ply", 3, ""},
    {"pdal/simple_text.ply", 3, ""},
    {"pdal/site_56_8.pts", 8, ""},
    {"pdal/sized_dims.ply", 0, "expected a column 'z', found none"},
    {"pdal/test.pts", 19, ""},
    {"pdal/text_extradim.ply", 1, ""},
    {"pdal/unsized_dims.ply", 0, "expected a column 'z', found none"},
    {"pdal/utm17_comma.pcd", 10, ""},
    {"pdal/utm17_space.pcd", 10, ""},
    {"pdal/utm17_tab.pcd", 10, ""},
    {"trimesh/cube_blender_uv.ply", 24, ""},
    {"trimesh/cube_blender_uv_meshlab.ply", 24, ""},
    {"trimesh/empty.ply", 0, "holds no points"},
    {"trimesh/metadata.ply", 4, "the last line has no end"},
    {"trimesh/multi.ply", 4, ""},
    {"trimesh/plane.ply", 4, ""},
    {"trimesh/plane_tri.ply", 4, ""},
    {"trimesh/ply_empty_ascii.ply", 0, "holds no points"},
    {"trimesh/ply_empty_bin.ply", 0, "holds no points"},
    {"trimesh/ply_empty_header.ply", 0, "expected an element 'vertex', found none"},
    {"trimesh/ply_points_ascii.ply", 8, ""},
    {"trimesh/ply_points_bin.ply", 8, "no normal is of any length"},
    {"trimesh/points_ascii.ply", 5, ""},
    {"trimesh/points_ascii_with_lists.ply", 5, ""},
    {"trimesh/points_bin.ply", 5, ""},
    {"trimesh/points_emptyascii.ply", 12, "lines after the declared elements"},
    {"trimesh/points_emptyface.ply", 1024, ""},
    {"trimesh/tet.ply", 4, ""},
};

std::filesystem::path odd_folder() {
  const char* const stated = std::getenv("AUGICP_SHARED_DATA");
  return std::filesystem::path(stated ? stated : AUGICP_SHARED_DATA_DIR) / "odd";
}

class OddFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_directory(odd_folder()))
      GTEST_SKIP() << "no folder " << odd_folder() << "; set AUGICP_SHARED_DATA";
  }
};

std::string said_of(const CloudFile& file) { return ::testing::PrintToString(file.report.warnings); }

void expect_as_stated(const OddFile& odd) {
  SCOPED_TRACE(odd.name);
  try {
    const CloudFile file = read_cloud(odd_folder() / odd.name);
    EXPECT_EQ(file.cloud.size(), odd.num_points);
    EXPECT_THAT(said_of(file), ::testing::HasSubstr(odd.says));
    EXPECT_EQ(file.report.warnings.empty(), std::string_view(odd.says).empty()) << said_of(file);
  } catch (const IoError& error) {
    EXPECT_EQ(odd.num_points, 0u) << error.what();
    EXPECT_THAT(error.what(), ::testing::HasSubstr(odd.says));
  }
}

TEST_F(OddFiles, EachGivesWhatIsStated) {
  for (const OddFile& odd : kOddFiles) expect_as_stated(odd);
}

TEST_F(OddFiles, NoneIsLeftOut) {
  std::set<std::string> stated;
  for (const OddFile& odd : kOddFiles) stated.insert(odd.name);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(odd_folder()))
    if (entry.is_regular_file()) {
      EXPECT_EQ(stated.count(std::filesystem::relative(entry.path(), odd_folder()).string()), 1u) << entry.path();
    }
}

TEST_F(OddFiles, OneShapeInThreeEncodingsIsOneCloud) {
  const Cloud little = read_cloud(odd_folder() / "happly/platonic_shelf.ply").cloud;
  EXPECT_EQ(read_cloud(odd_folder() / "happly/platonic_shelf_big_endian.ply").cloud.points, little.points);
  const Cloud utm = read_cloud(odd_folder() / "pdal/utm17_space.pcd").cloud;
  EXPECT_EQ(read_cloud(odd_folder() / "pdal/utm17_comma.pcd").cloud.points, utm.points);
  EXPECT_EQ(read_cloud(odd_folder() / "pdal/utm17_tab.pcd").cloud.points, utm.points);
  EXPECT_NEAR((utm.origin + utm.points[0].cast<double>()).y(), 4320978.61, 1e-6);
}

}  // namespace
}  // namespace augicp
