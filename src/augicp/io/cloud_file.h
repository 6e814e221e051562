// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/io/las_records.h"
#include "augicp/io/point_fields.h"

namespace augicp {

struct ReadOptions {
  std::uint64_t max_points = 100'000'000;  // files that declare or contain more are refused

  // Numbers per point in a .bin file, each a float32: 3 for positions alone, 4 as in KITTI (x y z intensity), or 5 or 6
  // with more behind, as in nuScenes. The file does not state it. 0: 4, 5 or 6, whichever the numbers fit, see
  // read_kitti.h.
  int num_bin_columns = 0;

  // Whether columns beside the cloud's own are kept, in CloudFile::fields. They take as much memory as in a binary
  // file.
  bool keep_fields = false;

  // Whether a .ply file with faces gives points on its faces, as .stl and .obj files always do, instead of its
  // vertices.
  bool sample_faces = false;
};

struct ReadReport {
  std::string format;                // such as "ply ascii"
  std::uint64_t num_declared = 0;    // number of points that the file states, or contains if it states none
  std::uint64_t num_not_finite = 0;  // dropped points: NaN, infinite, or beyond 1e18, where squares overflow a float
  bool has_normals = false;
  std::vector<std::string> warnings;  // one sentence each, without the path
};

// A cloud and the properties of its file.
//
// Coordinates are read as double and stored relative to cloud.origin. The origin is zero unless the cloud is more than
// 8 times farther from zero than its points are from each other. Normals become unit directions of Structure::Planar,
// oriented to the viewpoint if there is one. Without a usable normal the structure is None; if no point has a usable
// one, the cloud has no directions, with a warning. A column intensity or scalar_intensity, in either case, and KITTI's
// fourth number become intensities; NaN if they are not finite.
struct CloudFile {
  Cloud cloud;                     // never empty, every point finite
  std::optional<IndexImage> grid;  // organised files (several rows): the point in each pixel
  ReadReport report;
  std::optional<LasRecords> las{};  // only with ReadOptions::keep_fields, of LAS files: in place of fields
  PointFields fields{};             // only with ReadOptions::keep_fields; the intensities are here too, with their type
};

}  // namespace augicp
