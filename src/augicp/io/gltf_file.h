// SPDX-License-Identifier: MIT
// glTF 2.0 as a scene of triangles: its JSON, its buffers, its nodes. Source: the glTF 2.0 specification (Khronos).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/core/types.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/scalar_type.h"

namespace augicp {

// Numbers of a buffer: `count` items of several components each. All are within the buffer.
struct GltfNumbers {
  std::string_view bytes;
  std::size_t count = 0, stride = 0;
  ScalarType type = ScalarType::Float32;
  double unit = 1.0;  // of quantized positions: what the number 1 means

  double at(std::size_t item, std::size_t component) const;
};

enum class GltfMode { Points, Triangles, Strip, Fan };

// Vertices of a mesh as one node shows them.
struct GltfPart {
  GltfMode mode = GltfMode::Triangles;
  GltfNumbers positions;               // three components
  std::optional<GltfNumbers> indices;  // one component; none: all vertices in turn
  Mat4d world_from_mesh = Mat4d::Identity();

  std::size_t num_corners() const { return indices ? indices->count : positions.count; }
  std::size_t num_faces() const;  // 0 of points
};

struct GltfScene {
  std::vector<std::shared_ptr<const std::string>> buffers;  // what the parts look at
  std::vector<GltfPart> parts;
  std::vector<std::string> warnings;
};

// The scene that a .gltf or .glb file shows. Buffers beside a .gltf file are read from its folder. Throws IoError for
// damage, for compressed meshes (Draco, meshopt), for sparse accessors and for buffers elsewhere.
GltfScene read_gltf_scene(const FileBytes& file);

// ---- What the file is made of

struct GltfText {
  std::string_view json;
  std::optional<std::string_view> binary;  // the buffer within a .glb file
};

// By the mark of the file. Throws IoError.
GltfText gltf_text(const FileBytes& file);

// The bytes of a data URI in base64; empty if the URI names a file. Throws IoError.
std::optional<std::string> gltf_data(const FileBytes& file, std::string_view uri);

// The file in the folder of this one that a URI names. Throws IoError if that is elsewhere.
std::filesystem::path gltf_buffer_path(const FileBytes& file, std::string_view uri);

}  // namespace augicp
