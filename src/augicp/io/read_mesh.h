// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Points on the faces of an STL file, binary or ascii, of the polygons of a Wavefront OBJ file, or of a glTF scene
// (.gltf or .glb, see gltf_file.h); see mesh_samples.h. An OBJ file without faces gives its vertices, a glTF scene
// without faces its points. Throw IoError. Ascii files cut at a line are seen in STL (endsolid) but not in OBJ.
CloudFile parse_stl(const FileBytes& file, const ReadOptions& options);
CloudFile parse_obj(const FileBytes& file, const ReadOptions& options);
CloudFile parse_gltf(const FileBytes& file, const ReadOptions& options);

}  // namespace augicp
