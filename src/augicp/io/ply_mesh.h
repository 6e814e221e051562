// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/ply_header.h"

namespace augicp {

// Whether a PLY file has faces: an element 'face' with a list vertex_indices or vertex_index.
bool has_faces(const PlyHeader& header);

// Points on the faces, whose polygons are fans of triangles; see mesh_samples.h. Throws IoError. REQUIRES: has_faces().
CloudFile sampled_ply(const FileBytes& file, const PlyHeader& header, const ReadOptions& options);

}  // namespace augicp
