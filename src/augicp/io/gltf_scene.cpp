// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/gltf_document.h"

namespace augicp {
namespace {

using Json = GltfDocument::Json;

using Bytes = std::shared_ptr<const std::string>;

// The buffers of a file. Each file beside it is read once, however many buffers name it.
class BufferReader {
 public:
  explicit BufferReader(const GltfDocument& document) : document_(document) {}

  std::vector<Bytes> read() {
    std::vector<Bytes> buffers;
    for (const Json& buffer : document_.list(document_.root(), "buffers")) {
      if (!buffer.is_object()) document_.fail("expected objects in \"buffers\"");
      buffers.push_back(bytes_of(buffer, buffers.empty()));
      const std::size_t size = buffers.back()->size();
      if (const auto length = document_.count(buffer, "byteLength"); !length || *length > size)
        document_.fail(fmt::format("expected a buffer of {} bytes, found {}", length.value_or(0), size));
    }
    return buffers;
  }

 private:
  Bytes bytes_of(const Json& buffer, bool is_first) {
    const Json* const uri = GltfDocument::member(buffer, "uri");
    if (!uri && is_first && document_.binary()) return std::make_shared<const std::string>(*document_.binary());
    if (!uri || !uri->is_string()) document_.fail("expected a buffer with a \"uri\"");
    const auto& text = uri->get_ref<const std::string&>();
    if (auto data = gltf_data(document_.file(), text)) return std::make_shared<const std::string>(std::move(*data));
    const std::filesystem::path path = gltf_buffer_path(document_.file(), text);
    Bytes& known = beside_[path];
    if (!known) known = std::make_shared<const std::string>(read_beside(path));
    return known;
  }

  std::string read_beside(const std::filesystem::path& path) const {
    try {
      return read_bytes(path).bytes;
    } catch (const IoError& error) {
      document_.fail(std::string("its buffer cannot be read: ") + error.what());
    }
  }

  const GltfDocument& document_;
  std::map<std::filesystem::path, Bytes> beside_;
};

ScalarType type_of_component(const GltfDocument& document, std::uint64_t number) {
  constexpr ScalarType kTypes[] = {ScalarType::Int8, ScalarType::Uint8, ScalarType::Int16, ScalarType::Uint16};
  constexpr std::uint64_t kFirst = 5120, kUint32 = 5125, kFloat32 = 5126;
  if (number >= kFirst && number < kFirst + std::size(kTypes)) return kTypes[number - kFirst];
  if (number == kUint32) return ScalarType::Uint32;
  if (number != kFloat32) document.fail(fmt::format("expected a component type of glTF, found {}", number));
  return ScalarType::Float32;
}

// Normalised integers are shares of their largest.
double unit_of(ScalarType type, bool is_normalised) {
  if (!is_normalised || is_floating(type)) return 1.0;
  const bool is_signed = type == ScalarType::Int8 || type == ScalarType::Int16;
  return 1.0 / (std::exp2(8.0 * static_cast<double>(num_bytes(type)) - (is_signed ? 1.0 : 0.0)) - 1.0);
}

class SceneReader {
 public:
  explicit SceneReader(const FileBytes& file) : document_(file) {}

  GltfScene read() {
    refuse_compressed();
    scene_.buffers = BufferReader(document_).read();
    is_seen_.resize(document_.list(document_.root(), "nodes").size());
    for (const std::uint64_t root : roots()) add_node(root, Mat4d::Identity(), 0);
    return std::move(scene_);
  }

 private:
  void refuse_compressed() const {
    for (const Json& extension : document_.list(document_.root(), "extensionsRequired"))
      for (const char* known : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
        if (extension == known)
          document_.fail(
              fmt::format("expected plain meshes, found {}; gltf-transform or Blender writes plain ones", known));
  }

  // The nodes of the scene that is shown; without scenes those that are no children.
  std::vector<std::uint64_t> roots() const {
    std::vector<std::uint64_t> found;
    const Json& root = document_.root();
    if (!document_.list(root, "scenes").empty()) {
      const Json& scene = document_.item("scenes", document_.count(root, "scene").value_or(0));
      for (const Json& node : document_.list(scene, "nodes")) found.push_back(document_.index(node, "nodes"));
      return found;
    }
    std::vector<bool> is_child(is_seen_.size());
    for (std::uint64_t i = 0; i < is_child.size(); ++i)
      for (const Json& child : document_.list(document_.item("nodes", i), "children"))
        if (const std::uint64_t index = document_.index(child, "children"); index < is_child.size())
          is_child[index] = true;
    for (std::uint64_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) found.push_back(i);
    return found;
  }

  // Nodes are trees: none is reached twice.
  void add_node(std::uint64_t index, const Mat4d& world_from_parent, int depth) {
    constexpr int kDeepest = 256;
    const Json& node = document_.item("nodes", index);
    if (is_seen_[index] || depth > kDeepest) document_.fail(fmt::format("node {} is reached twice", index));
    is_seen_[index] = true;
    const Mat4d world_from_node = world_from_parent * parent_from(node);
    if (node.contains("skin")) warn("meshes with a skin are read as they lie in the file");
    if (const auto mesh = document_.count(node, "mesh")) add_mesh(*mesh, world_from_node);
    for (const Json& child : document_.list(node, "children"))
      add_node(document_.index(child, "children"), world_from_node, depth + 1);
  }

  // A matrix, column by column, or translation, rotation and scale.
  Mat4d parent_from(const Json& node) const {
    if (const auto matrix = document_.numbers(node, "matrix", 16)) return Mat4d(matrix->data());
    Mat4d moved = Mat4d::Identity();
    const auto t = document_.numbers(node, "translation", 3), q = document_.numbers(node, "rotation", 4),
               s = document_.numbers(node, "scale", 3);
    if (q) moved.topLeftCorner<3, 3>() = Eigen::Quaterniond((*q)[3], (*q)[0], (*q)[1], (*q)[2]).normalized().matrix();
    for (int axis = 0; axis < 3; ++axis) {
      if (s) moved.col(axis) *= (*s)[static_cast<std::size_t>(axis)];
      if (t) moved(axis, 3) = (*t)[static_cast<std::size_t>(axis)];
    }
    return moved;
  }

  void add_mesh(std::uint64_t index, const Mat4d& world_from_mesh) {
    for (const Json& primitive : document_.list(document_.item("meshes", index), "primitives")) {
      if (!primitive.is_object()) document_.fail("expected objects in \"primitives\"");
      const auto mode = mode_of(document_.count(primitive, "mode").value_or(4));
      const Json* const attributes = GltfDocument::member(primitive, "attributes");
      const auto positions =
          attributes && attributes->is_object() ? document_.count(*attributes, "POSITION") : std::nullopt;
      if (!mode || !positions) continue;
      GltfPart part{*mode, numbers_of(*positions, "VEC3"), std::nullopt, world_from_mesh};
      if (const auto indices = document_.count(primitive, "indices")) part.indices = indices_of(*indices);
      add(std::move(part));
    }
  }

  // Many nodes of a small file may each show a mesh of many primitives.
  void add(GltfPart part) {
    constexpr std::size_t kMostParts = 1u << 20;
    if (scene_.parts.size() == kMostParts)
      document_.fail(fmt::format("expected at most {} primitives in all nodes, found more", kMostParts));
    scene_.parts.push_back(std::move(part));
  }

  GltfNumbers indices_of(std::uint64_t accessor_index) const {
    const GltfNumbers indices = numbers_of(accessor_index, "SCALAR");
    if (indices.type != ScalarType::Uint8 && indices.type != ScalarType::Uint16 && indices.type != ScalarType::Uint32)
      document_.fail("expected indices of an unsigned component type");
    return indices;
  }

  std::optional<GltfMode> mode_of(std::uint64_t number) {
    switch (number) {
      case 0:
        return GltfMode::Points;
      case 4:
        return GltfMode::Triangles;
      case 5:
        return GltfMode::Strip;
      case 6:
        return GltfMode::Fan;
      case 1:
      case 2:
      case 3:
        warn("lines are not read");
        return std::nullopt;
      default:
        document_.fail(fmt::format("expected a mode from 0 to 6, found {}", number));
    }
  }

  GltfNumbers numbers_of(std::uint64_t accessor_index, std::string_view shape) const {
    const Json& accessor = document_.item("accessors", accessor_index);
    const Json* const type = GltfDocument::member(accessor, "type");
    if (!type || *type != shape) document_.fail(fmt::format("expected numbers of the type {}", shape));
    const auto view_index = document_.count(accessor, "bufferView");
    if (accessor.contains("sparse") || !view_index)
      document_.fail("expected numbers in a buffer view, found sparse ones");
    GltfNumbers numbers;
    numbers.type = type_of_component(document_, document_.count(accessor, "componentType").value_or(0));
    const Json* const normalised = GltfDocument::member(accessor, "normalized");
    numbers.unit = unit_of(numbers.type, normalised && *normalised == true);
    numbers.count = document_.count(accessor, "count").value_or(0);
    place(document_.item("bufferViews", *view_index), document_.count(accessor, "byteOffset").value_or(0),
          num_bytes(numbers.type) * (shape == "VEC3" ? 3 : 1), numbers);
    return numbers;
  }

  // Finds the bytes of items of this size.
  void place(const Json& view, std::uint64_t offset, std::size_t item_bytes, GltfNumbers& numbers) const {
    const std::uint64_t buffer = document_.count(view, "buffer").value_or(0),
                        begin = document_.count(view, "byteOffset").value_or(0),
                        length = document_.count(view, "byteLength").value_or(0);
    numbers.stride = document_.count(view, "byteStride").value_or(item_bytes);
    if (buffer >= scene_.buffers.size()) document_.fail(fmt::format("expected a buffer {}", buffer));
    const std::string_view bytes = *scene_.buffers[buffer];
    const bool is_in_buffer = begin <= bytes.size() && length <= bytes.size() - begin && offset <= length;
    const bool fits = is_in_buffer && numbers.count > 0 && numbers.stride >= item_bytes &&
                      item_bytes <= length - offset &&
                      (length - offset - item_bytes) / numbers.stride >= numbers.count - 1;
    if (!fits)
      document_.fail(fmt::format("expected {} numbers of {} bytes in a view of {} bytes at {} of a buffer of {}",
                                 numbers.count, item_bytes, length, begin, bytes.size()));
    numbers.bytes = bytes.substr(begin + offset, length - offset);
  }

  void warn(const std::string& sentence) {
    for (const std::string& known : scene_.warnings)
      if (known == sentence) return;
    scene_.warnings.push_back(sentence);
  }

  GltfDocument document_;
  GltfScene scene_;
  std::vector<bool> is_seen_;  // by node
};

}  // namespace

double GltfNumbers::at(std::size_t item, std::size_t component) const {
  return unit * read_scalar(bytes.data() + item * stride + component * num_bytes(type), type, ByteOrder::Little);
}

std::size_t GltfPart::num_faces() const {
  if (mode == GltfMode::Points) return 0;
  if (mode == GltfMode::Triangles) return num_corners() / 3;
  return num_corners() < 3 ? 0 : num_corners() - 2;
}

GltfScene read_gltf_scene(const FileBytes& file) { return SceneReader(file).read(); }

}  // namespace augicp
