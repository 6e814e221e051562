// SPDX-License-Identifier: MIT
// Damaged files, by the thousand: each is refused, or gives a cloud whose promises hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "augicp/io/depth_png.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/write_cloud.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

constexpr int kNumMutants = 500;  // of each file

std::vector<FileBytes> healthy_files() {
  const testing::TemporaryFolder folder;
  std::mt19937 generator(5);
  Cloud cloud;
  for (int i = 0; i < 20; ++i) {
    cloud.points.push_back(testing::random_direction(generator).cast<float>());
    cloud.directions.push_back(testing::random_direction(generator).cast<float>());
    cloud.structures.push_back(Structure::Planar);
    cloud.intensities.push_back(static_cast<float>(i));
  }
  write_ply(folder / "binary.ply", cloud);
  write_ply(folder / "text.ply", cloud, {}, FileEncoding::Ascii);
  write_pcd(folder / "binary.pcd", cloud);
  write_pcd(folder / "text.pcd", cloud, FileEncoding::Ascii);
  write_depth_png(folder / "depth.png", {3, 2, {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}}, 1000.0);
  std::vector<FileBytes> files;
  for (const char* name : {"binary.ply", "text.ply", "binary.pcd", "text.pcd", "depth.png"})
    files.push_back(read_bytes(folder / name));
  using namespace std::string_literals;
  files.push_back(
      {"faces.ply",
       "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty list uchar short i\nelement vertex 2\n"
       "property short x\nproperty short y\nproperty short z\nend_header\n\2\0\1\0\2\1\0\3\0\1\0\2\0\3\0\4\0\5\0\6"s});
  files.push_back({"small.pcd",
                   "FIELDS x y z\nSIZE 1 1 1\nTYPE I I I\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 2\nDATA binary_compressed\n"
                   "\15\0\0\0\14\0\0\0\13abcdefghijkl"s});
  files.push_back({"cloud.pts", "3\n1 2 3\n4 5 6\n7 8 9\n"});
  files.push_back({"cloud.csv", "x,y,z,nx,ny,nz\n1,2,3,0,0,1\n4,5,6,0,1,0\n"});
  files.push_back({"cloud.bin", std::string(64, '\x40')});
  files.push_back(
      {"cloud.npy", "\x93NUMPY\1\0\x46\0{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2, 3), }        \n"s +
                        std::string(48, '\x40')});
  return files;
}

void flip_bytes(std::string& bytes, std::mt19937& generator) {
  for (unsigned i = 0; i <= generator() % 4; ++i) bytes[generator() % bytes.size()] = static_cast<char>(generator());
}

void replace_a_number(std::string& bytes, std::mt19937& generator) {
  constexpr const char* kNumbers[] = {"0",     "-1",  "1", "2147483647", "4294967296", "9223372036854775808",
                                      "1e308", "nan", "",  "65536",      "1e-320"};
  const std::size_t begin = bytes.find_first_of("0123456789", generator() % bytes.size());
  if (begin == std::string::npos) return;
  const std::size_t end = std::min(bytes.find_first_not_of("0123456789", begin), bytes.size());
  bytes.replace(begin, end - begin, kNumbers[generator() % std::size(kNumbers)]);
}

std::string mutant(std::string bytes, std::mt19937& generator) {
  switch (generator() % 5) {
    case 0:
      bytes.resize(generator() % bytes.size());
      break;
    case 1:
      replace_a_number(bytes, generator);
      break;
    case 2:
      bytes.erase(generator() % bytes.size(), 1 + generator() % 8);
      break;
    case 3:
      bytes.insert(generator() % bytes.size(), bytes.substr(generator() % bytes.size(), generator() % 16));
      break;
    default:
      flip_bytes(bytes, generator);
  }
  return bytes;
}

bool keeps_its_promises(const CloudFile& file) {
  const Cloud& cloud = file.cloud;
  bool holds = !cloud.empty() && cloud.origin.allFinite() && cloud.structures.size() == cloud.directions.size() &&
               (cloud.directions.empty() || cloud.directions.size() == cloud.size()) &&
               cloud.size() + file.report.num_not_finite == file.report.num_declared;
  for (const Vec3f& point : cloud.points) holds = holds && point.allFinite();
  for (std::size_t i = 0; i < cloud.directions.size(); ++i) {
    const float length = cloud.structures[i] == Structure::None ? 0.0f : 1.0f;
    holds = holds && std::abs(cloud.directions[i].norm() - length) < 1e-5f;
  }
  if (file.grid)
    for (const std::int32_t index : file.grid->index)
      holds = holds && index >= -1 && index < static_cast<std::int32_t>(cloud.size());
  return holds;
}

TEST(Mutation, HealthyFilesAreRead) {
  for (const FileBytes& file : healthy_files()) {
    if (file.path.extension() == ".png") {
      EXPECT_NO_THROW(parse_depth_png(file, 1000.0));
    } else {
      EXPECT_NO_THROW(EXPECT_TRUE(keeps_its_promises(parse_cloud(file)))) << file.path;
    }
  }
}

// robustness 1 to 7
TEST(Mutation, DamagedFilesAreRefusedOrKeepThePromises) {
  std::mt19937 generator(20);
  for (const FileBytes& file : healthy_files()) {
    for (int i = 0; i < kNumMutants; ++i) {
      const FileBytes damaged{file.path, mutant(file.bytes, generator)};
      try {
        if (file.path.extension() == ".png") {
          parse_depth_png(damaged, 1000.0);
        } else {
          ASSERT_TRUE(keeps_its_promises(parse_cloud(damaged))) << file.path << " mutant " << i;
        }
      } catch (const IoError& error) {
        ASSERT_EQ(std::string(error.what()).rfind(file.path.string() + ": ", 0), 0u) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace augicp
