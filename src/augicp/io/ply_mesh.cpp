// SPDX-License-Identifier: MIT
#include "augicp/io/ply_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/mesh_samples.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/text_points.h"

namespace augicp {
namespace {

bool is_corners(const PlyProperty& property) {
  return property.list_length && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_face(const PlyElement& element) {
  return element.name == "face" && element.count > 0 &&
         std::any_of(element.properties.begin(), element.properties.end(), is_corners);
}

// The numbers of a body, record after record.
class Body {
 public:
  virtual ~Body() = default;
  virtual void begin_record() {}
  virtual double take(ScalarType type) = 0;
  virtual bool is_at_end() = 0;
};

class BinaryBody : public Body {
 public:
  BinaryBody(const FileBytes& file, const PlyHeader& header)
      : file_(file),
        order_(header.encoding == PlyEncoding::BinaryBigEndian ? ByteOrder::Big : ByteOrder::Little),
        at_(header.body_offset) {}

  double take(ScalarType type) override {
    const std::size_t size = num_bytes(type);
    if (size > file_.bytes.size() - at_)
      throw io_error_at_byte(file_.path, at_, "expected more of its elements, the file ends here");
    const double number = read_scalar(file_.bytes.data() + at_, type, order_);
    at_ += size;
    return number;
  }

  bool is_at_end() override { return at_ == file_.bytes.size(); }

 private:
  const FileBytes& file_;
  ByteOrder order_;
  std::size_t at_;
};

// A record is a line.
class TextBody : public Body {
 public:
  TextBody(const FileBytes& file, const PlyHeader& header)
      : file_(file), num_before_(header.num_lines), lines_(std::string_view(file.bytes).substr(header.body_offset)) {}

  void begin_record() override {
    const auto line = lines_.next_not_blank();
    if (!line) throw io_error(file_.path, "expected more of its elements, the file ends");
    rest_ = *line;
  }

  double take(ScalarType) override {
    const std::string_view field = next_field(rest_).value_or("");
    const auto number = parse_double(field);
    if (!number)
      throw io_error_at_line(file_.path, num_before_ + lines_.line(), "expected a number, found " + in_quotes(field));
    return *number;
  }

  bool is_at_end() override { return !lines_.next_not_blank(); }

 private:
  const FileBytes& file_;
  std::uint64_t num_before_;
  TextLines lines_;
  std::string_view rest_;
};

class MeshReader {
 public:
  MeshReader(const FileBytes& file, Body& body) : file_(file), body_(body) {}

  void read(const PlyElement& element) {
    const bool are_vertices = element.name == "vertex", are_faces = is_face(element);
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      body_.begin_record();
      Vec3d vertex = Vec3d::Constant(std::nan(""));
      for (const PlyProperty& property : element.properties)
        if (property.list_length) {
          take_list(property, are_faces && is_corners(property));
        } else {
          const double number = body_.take(property.type);
          if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
            vertex[property.name[0] - 'x'] = number;
        }
      if (are_vertices) vertices_.push_back(vertex);
    }
  }

  // Throws IoError for corners that are no vertices.
  void check() const {
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (const std::uint32_t corner : faces_[i])
        if (corner >= vertices_.size())
          throw io_error(file_.path, fmt::format("triangle {} has vertex {}, expected less than {}", i + 1, corner,
                                                 vertices_.size()));
  }

  std::size_t num_faces() const { return faces_.size(); }

  Triangle face(std::size_t i) const {
    const auto& [a, b, c] = faces_[i];
    return {vertices_[a], vertices_[b], vertices_[c]};
  }

 private:
  void take_list(const PlyProperty& property, bool is_polygon) {
    const double length = count_in(body_.take(*property.list_length), "a list length");
    std::uint32_t first = 0, last = 0;
    for (double i = 0; i < length; ++i) {
      const double number = body_.take(property.type);
      if (!is_polygon) continue;
      const auto corner = static_cast<std::uint32_t>(count_in(number, "a vertex"));
      if (i == 0) first = corner;
      if (i > 1) faces_.push_back({first, last, corner});
      last = corner;
    }
  }

  double count_in(double number, const char* what) const {
    constexpr double kMost = 4294967295.0;
    if (!(number >= 0.0 && number <= kMost) || number != std::floor(number))
      throw io_error(file_.path, fmt::format("expected {}, found {}", what, number));
    return number;
  }

  const FileBytes& file_;
  Body& body_;
  std::vector<Vec3d> vertices_;
  std::vector<std::array<std::uint32_t, 3>> faces_;
};

}  // namespace

bool has_faces(const PlyHeader& header) { return std::any_of(header.elements.begin(), header.elements.end(), is_face); }

CloudFile sampled_ply(const FileBytes& file, const PlyHeader& header, const ReadOptions& options) {
  const bool is_text = header.encoding == PlyEncoding::Ascii;
  std::unique_ptr<Body> body;
  if (is_text)
    body = std::make_unique<TextBody>(file, header);
  else
    body = std::make_unique<BinaryBody>(file, header);
  MeshReader reader(file, *body);
  for (const PlyElement& element : header.elements) reader.read(element);
  reader.check();
  CloudFile read =
      sampled_cloud(file, {"ply mesh", reader.num_faces(), [&](std::size_t i) { return reader.face(i); }}, options);
  if (!body->is_at_end()) read.report.warnings.push_back("what is behind the declared elements was not read");
  if (is_text && !ends_with_a_line_end(file.bytes)) read.report.warnings.push_back(kNoLineEndWarning);
  return read;
}

}  // namespace augicp
