// SPDX-License-Identifier: MIT
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/mesh_samples.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/read_mesh.h"
#include "augicp/io/scalar_type.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

constexpr std::size_t kStlHeader = 84, kFace = 50, kNormal = 12;  // bytes

std::uint64_t stated_count(const FileBytes& file) {
  return static_cast<std::uint64_t>(
      read_scalar(file.bytes.data() + kStlHeader - 4, ScalarType::Uint32, ByteOrder::Little));
}

// Many binary files begin with "solid" too: the size decides.
bool is_binary(const FileBytes& file) {
  return file.bytes.size() >= kStlHeader && file.bytes.size() == kStlHeader + kFace * stated_count(file);
}

Triangle binary_face(const FileBytes& file, std::size_t i) {
  Triangle face;
  const char* at = file.bytes.data() + kStlHeader + kFace * i + kNormal;
  for (Vec3d& corner : face)
    for (int axis = 0; axis < 3; ++axis, at += 4)
      corner[axis] = read_scalar(at, ScalarType::Float32, ByteOrder::Little);
  return face;
}

Vec3f corner_of(const FileBytes& file, std::string_view rest, std::uint64_t line) {
  Vec3f corner;
  for (int axis = 0; axis < 3; ++axis) {
    const auto field = next_field(rest);
    const auto number = field ? parse_double(*field) : std::nullopt;
    if (!number) throw io_error_at_line(file.path, line, "expected 'vertex x y z'");
    corner[axis] = static_cast<float>(*number);
  }
  if (next_field(rest)) throw io_error_at_line(file.path, line, "expected 'vertex x y z', found more");
  return corner;
}

// The corners of all faces in turn. Binary files have float too.
std::vector<Vec3f> ascii_corners(const FileBytes& file) {
  std::vector<Vec3f> corners;
  std::size_t num_closed = 0;
  bool has_end = false;
  TextLines lines(file.bytes);
  while (const auto line = lines.next_not_blank()) {
    std::string_view rest = *line;
    const std::string_view word = next_field(rest).value_or("");
    if (has_end && word != "solid")
      throw io_error_at_line(file.path, lines.line(), "expected nothing behind 'endsolid'");
    if (word == "solid") has_end = false;
    if (word == "endsolid") has_end = true;
    if (word == "vertex") corners.push_back(corner_of(file, rest, lines.line()));
    if (word == "endfacet" && corners.size() != 3 * ++num_closed)
      throw io_error_at_line(file.path, lines.line(), "expected three vertices a facet");
  }
  if (!has_end || corners.size() != 3 * num_closed)
    throw io_error_at_line(file.path, lines.line(), "expected 'endsolid', the file ends here");
  return corners;
}

}  // namespace

CloudFile parse_stl(const FileBytes& file, const ReadOptions& options) {
  if (is_binary(file))
    return sampled_cloud(file, {"stl binary", stated_count(file), [&](std::size_t i) { return binary_face(file, i); }},
                         options);
  if (!file.bytes.starts_with("solid")) {
    const bool has_header = file.bytes.size() >= kStlHeader;
    throw io_error(file.path, has_header ? fmt::format("expected {} bytes of {} faces, found {}",
                                                       kStlHeader + kFace * stated_count(file), stated_count(file),
                                                       file.bytes.size())
                                         : "expected a header of 84 bytes, or 'solid'");
  }
  check_is_text(file);
  const std::vector<Vec3f> corners = ascii_corners(file);
  const auto face = [&](std::size_t i) {
    return Triangle{corners[3 * i].cast<double>(), corners[3 * i + 1].cast<double>(),
                    corners[3 * i + 2].cast<double>()};
  };
  return sampled_cloud(file, {"stl ascii", corners.size() / 3, face}, options);
}

}  // namespace augicp
