// SPDX-License-Identifier: MIT
// Clouds of points on the faces of a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The corners of a face, metres; its normal points to where they are seen counterclockwise.
using Triangle = std::array<Vec3d, 3>;

// The faces of a mesh file, read on demand.
struct MeshFaces {
  std::string format;
  std::size_t count = 0;
  std::function<Triangle(std::size_t)> face;
};

// Points spread evenly over the area of all faces, each with the normal of its face: 1000 a face, and at most 200 000.
// The same faces give the same points; the points of faces without an area are none. Throws IoError if no face has an
// area, or one of them is not finite.
CloudFile sampled_cloud(const FileBytes& file, const MeshFaces& faces, const ReadOptions& options);

}  // namespace augicp
