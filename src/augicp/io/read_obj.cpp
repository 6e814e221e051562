// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/mesh_samples.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/read_mesh.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

// Vertices relative to the first one, so that float suffices far from zero.
struct ObjMesh {
  Vec3d origin = Vec3d::Zero();
  std::vector<Vec3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;

  Vec3d vertex(std::size_t i) const { return origin + vertices[i].cast<double>(); }
};

class ObjReader {
 public:
  explicit ObjReader(const FileBytes& file) : file_(file), lines_(without_bom(file.bytes)) {}

  ObjMesh read() {
    while (const auto line = lines_.next_not_blank()) {
      std::string_view rest = line->substr(0, line->find('#'));
      const std::string_view word = next_field(rest).value_or("");
      if (word == "v") add_vertex(rest);
      if (word == "f") add_polygon(rest);
      if (trimmed(*line).ends_with('\\')) fail("a line that goes on in the next one is not understood");
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::string_view what) const { throw io_error_at_line(file_.path, lines_.line(), what); }

  void add_vertex(std::string_view rest) {
    Vec3d vertex;
    for (int axis = 0; axis < 3; ++axis) {
      const auto field = next_field(rest);
      const auto number = field ? parse_double(*field) : std::nullopt;
      if (!number || !(std::abs(*number) < 1e18)) fail("expected 'v x y z' of finite numbers");
      vertex[axis] = *number;
    }
    if (mesh_.vertices.empty()) mesh_.origin = vertex;
    mesh_.vertices.push_back((vertex - mesh_.origin).cast<float>());
  }

  // A fan of triangles around the first corner.
  void add_polygon(std::string_view rest) {
    std::optional<std::uint32_t> first, last;
    std::size_t num_corners = 0;
    while (const auto field = next_field(rest)) {
      const std::uint32_t corner = corner_of(*field);
      if (++num_corners > 2) mesh_.faces.push_back({*first, *last, corner});
      if (!first) first = corner;
      last = corner;
    }
    if (num_corners < 3) fail("expected 'f' with three corners at least");
  }

  // A corner is "7", "7/1", "7//3" or "7/1/3": the first number counts from 1, or backwards from -1.
  std::uint32_t corner_of(std::string_view field) const {
    const std::string_view digits = field.substr(0, field.find('/'));
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    if (error != std::errc{} || end != digits.data() + digits.size() || index == 0 || index > count || index < -count)
      fail(fmt::format("expected a corner among the {} vertices before, found {}", count, in_quotes(field)));
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
  }

  const FileBytes& file_;
  TextLines lines_;
  ObjMesh mesh_;
};

CloudFile cloud_of_vertices(const FileBytes& file, const ObjMesh& mesh, const ReadOptions& options) {
  check_num_points(file.path, mesh.vertices.size(), options);
  PointTable table;
  table.format = "obj vertices";
  table.num_points = mesh.vertices.size();
  return build_cloud(file, table, [&](CloudBuilder& builder) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Vec3d vertex = mesh.vertex(i);
      builder.add({vertex.x(), vertex.y(), vertex.z()});
    }
  });
}

}  // namespace

CloudFile parse_obj(const FileBytes& file, const ReadOptions& options) {
  check_is_text(file);
  const ObjMesh mesh = ObjReader(file).read();
  const auto face = [&](std::size_t i) {
    const auto& [a, b, c] = mesh.faces[i];
    return Triangle{mesh.vertex(a), mesh.vertex(b), mesh.vertex(c)};
  };
  CloudFile read = mesh.faces.empty() ? cloud_of_vertices(file, mesh, options)
                                      : sampled_cloud(file, {"obj", mesh.faces.size(), face}, options);
  if (!ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

}  // namespace augicp
