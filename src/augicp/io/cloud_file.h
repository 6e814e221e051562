// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"

namespace augicp {

struct ReadOptions {
  std::uint64_t max_points = 100'000'000;  // files that declare or hold more are refused

  // Numbers a point in a .bin file, of float32 each: KITTI's 4 (x y z intensity), or 3 for bare positions. The file
  // does not say.
  int num_bin_columns = 4;
};

struct ReadReport {
  std::string format;                // such as "ply ascii"
  std::uint64_t num_declared = 0;    // points the file states it has, or has where it states nothing
  std::uint64_t num_not_finite = 0;  // of these, dropped: NaN, infinite, or beyond 1e18 where squares overflow a float
  bool has_normals = false;
  std::vector<std::string> warnings;  // one sentence each, without the path
};

// A cloud and what its file said about it.
//
// Coordinates are read as double and kept relative to cloud.origin. The origin is zero unless the cloud lies more than
// 8 times farther from zero than its points lie from each other. Normals become unit directions of Structure::Planar,
// turned to the viewpoint where there is one; where a file gives no usable normal the structure is None. A column
// intensity or scalar_intensity, in either case, and KITTI's fourth number become intensities, NaN where they are not
// finite.
struct CloudFile {
  Cloud cloud;                     // never empty, every point finite
  std::optional<IndexImage> grid;  // of organised files (several rows): which point is in which pixel
  ReadReport report;
};

}  // namespace augicp
