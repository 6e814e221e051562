// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "augicp/io/format.h"
#include "augicp/io/spread.h"

namespace augicp {
namespace {

constexpr std::size_t kBufferBytes = 1 << 20;

template <typename T>
void append(std::string& out, T value, FileEncoding encoding) {
  if (encoding == FileEncoding::Ascii) {
    fmt::format_to(std::back_inserter(out), "{} ", value);  // the shortest digits that read back exactly
    return;
  }
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(T));
  out.append(bytes, sizeof(T));
}

template <typename Vector>
void append_vector(std::string& out, const Vector& vector, FileEncoding encoding) {
  for (int axis = 0; axis < 3; ++axis) append(out, vector[axis], encoding);
}

std::vector<RowColumn> vector_columns(const char* prefix, const char* suffixes, ScalarType type) {
  std::vector<RowColumn> columns;
  for (int axis = 0; axis < 3; ++axis) columns.push_back({std::string(prefix) + suffixes[axis], type});
  return columns;
}

bool has_point(const Row& row) { return row.point != IndexImage::kNone; }

void check_sizes(const Cloud& cloud, const PointFields& fields, const IndexImage* grid) {
  if (cloud.empty()) throw std::invalid_argument("cloud: must hold points to be written");
  const std::size_t num_rows = grid ? grid->index.size() : cloud.size();
  for (const PointField& field : fields.fields)
    if (field.values.size() != num_rows * field.row_bytes())
      throw std::invalid_argument(
          fmt::format("{}: expected {} rows, found {}", field.name, num_rows, field.num_rows()));
  if (cloud.structures.size() != cloud.directions.size())
    throw std::invalid_argument("cloud: must have as many structures as directions");
  if (!cloud.intensities.empty() && !cloud.has_intensities())
    throw std::invalid_argument("cloud: must have as many intensities as points, or none");
}

Vec3d position_in_frame(const Cloud& cloud, const Row& row) {
  if (!has_point(row)) return Vec3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return cloud.origin + cloud.points[static_cast<std::size_t>(row.point)].cast<double>();
}

bool fits_float(const Cloud& cloud) {
  if (cloud.origin.isZero(0.0)) return true;
  return float_suffices(spread_of(cloud.size(), [&](std::size_t i) {
    return position_in_frame(cloud, {static_cast<std::int32_t>(i), i});
  }));
}

RowPart positions(const Cloud& cloud, FileEncoding encoding) {
  if (fits_float(cloud))
    return {vector_columns("", "xyz", ScalarType::Float32), [&cloud, encoding](const Row& row, std::string& out) {
              append_vector(out, Vec3f(position_in_frame(cloud, row).cast<float>()), encoding);
            }};
  return {vector_columns("", "xyz", ScalarType::Float64), [&cloud, encoding](const Row& row, std::string& out) {
            append_vector(out, position_in_frame(cloud, row), encoding);
          }};
}

// The direction of the points with this structure.
RowPart directions(const Cloud& cloud, Structure structure, FileEncoding encoding) {
  const char* const prefix = structure == Structure::Planar ? "n" : "tangent_";
  return {vector_columns(prefix, "xyz", ScalarType::Float32),
          [&cloud, structure, encoding](const Row& row, std::string& out) {
            const auto i = static_cast<std::size_t>(row.point);
            const bool has_one = has_point(row) && cloud.structures[i] == structure;
            append_vector(out, has_one ? cloud.directions[i] : Vec3f(Vec3f::Zero()), encoding);
          }};
}

RowPart structures(const Cloud& cloud, FileEncoding encoding) {
  return {{{"structure", ScalarType::Uint8}}, [&cloud, encoding](const Row& row, std::string& out) {
            const Structure structure =
                has_point(row) ? cloud.structures[static_cast<std::size_t>(row.point)] : Structure::None;
            append(out, static_cast<std::uint8_t>(structure), encoding);
          }};
}

RowPart intensities(const Cloud& cloud, FileEncoding encoding) {
  return {{{"intensity", ScalarType::Float32}}, [&cloud, encoding](const Row& row, std::string& out) {
            append(out,
                   has_point(row) ? cloud.intensities[static_cast<std::size_t>(row.point)]
                                  : std::numeric_limits<float>::quiet_NaN(),
                   encoding);
          }};
}

RowPart part_of(const PointField& field, FileEncoding encoding) {
  return {{{field.name, field.type, field.count}}, [&field, encoding](const Row& row, std::string& out) {
            const char* number = field.values.data() + row.of_fields * field.row_bytes();
            with_type(field.type, [&](auto value) {
              for (std::size_t k = 0; k < field.count; ++k, number += sizeof(value)) {
                std::memcpy(&value, number, sizeof(value));
                append(out, value, encoding);
              }
            });
          }};
}

}  // namespace

std::vector<RowPart> row_parts(const Cloud& cloud, const PointFields& fields, const IndexImage* grid,
                               FileEncoding encoding) {
  check_sizes(cloud, fields, grid);
  std::vector<RowPart> parts{positions(cloud, encoding)};
  if (cloud.has_directions()) {
    parts.push_back(directions(cloud, Structure::Planar, encoding));
    parts.push_back(structures(cloud, encoding));
    const std::vector<Structure>& found = cloud.structures;
    if (std::find(found.begin(), found.end(), Structure::Edge) != found.end())
      parts.push_back(directions(cloud, Structure::Edge, encoding));
  }
  const bool fields_have_it = fields.find("intensity") || fields.find("scalar_intensity");
  if (cloud.has_intensities() && !fields_have_it) parts.push_back(intensities(cloud, encoding));
  for (const PointField& field : fields.fields) parts.push_back(part_of(field, encoding));
  return parts;
}

std::vector<RowColumn> columns_of(const std::vector<RowPart>& parts) {
  std::vector<RowColumn> columns;
  for (const RowPart& part : parts) columns.insert(columns.end(), part.columns.begin(), part.columns.end());
  return columns;
}

void write_rows(AtomicFile& file, const std::vector<RowPart>& parts, std::size_t num_points, const IndexImage* grid,
                FileEncoding encoding) {
  std::string rows;
  const std::size_t num_rows = grid ? grid->index.size() : num_points;
  for (std::size_t i = 0; i < num_rows; ++i) {
    const Row row{grid ? grid->index[i] : static_cast<std::int32_t>(i), i};
    for (const RowPart& part : parts) part.append(row, rows);
    if (encoding == FileEncoding::Ascii) rows.back() = '\n';
    if (rows.size() < kBufferBytes) continue;
    file.write(rows);
    rows.clear();
  }
  file.write(rows);
}

}  // namespace augicp
