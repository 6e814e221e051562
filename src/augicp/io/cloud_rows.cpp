// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <stdexcept>

#include "augicp/io/format.h"

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

}  // namespace

std::vector<RowColumn> row_columns(const Cloud& cloud, std::span<const Colour> colours) {
  if (cloud.empty()) throw std::invalid_argument("cloud: must hold points to be written");
  if (!colours.empty() && colours.size() != cloud.size())
    throw std::invalid_argument(fmt::format("colours: expected {}, found {}", cloud.size(), colours.size()));
  if (cloud.structures.size() != cloud.directions.size())
    throw std::invalid_argument("cloud: must have as many structures as directions");
  if (!cloud.intensities.empty() && !cloud.has_intensities())
    throw std::invalid_argument("cloud: must have as many intensities as points, or none");
  const ScalarType position = cloud.origin.isZero(0.0) ? ScalarType::Float32 : ScalarType::Float64;
  std::vector<RowColumn> columns{{"x", position}, {"y", position}, {"z", position}};
  if (cloud.has_directions())
    for (const char* name : {"nx", "ny", "nz"}) columns.push_back({name, ScalarType::Float32});
  if (cloud.has_directions()) columns.push_back({"structure", ScalarType::Uint8});
  if (cloud.has_intensities()) columns.push_back({"intensity", ScalarType::Float32});
  if (!colours.empty())
    for (const char* name : {"red", "green", "blue"}) columns.push_back({name, ScalarType::Uint8});
  return columns;
}

void write_rows(AtomicFile& file, const Cloud& cloud, std::span<const Colour> colours, FileEncoding encoding) {
  const bool near = cloud.origin.isZero(0.0);
  std::string rows;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (near) {
      append_vector(rows, cloud.points[i], encoding);
    } else {
      append_vector(rows, Vec3d(cloud.origin + cloud.points[i].cast<double>()), encoding);
    }
    if (cloud.has_directions()) {
      append_vector(rows, cloud.directions[i], encoding);
      append(rows, static_cast<std::uint8_t>(cloud.structures[i]), encoding);
    }
    if (cloud.has_intensities()) append(rows, cloud.intensities[i], encoding);
    if (!colours.empty()) append_vector(rows, colours[i], encoding);
    if (encoding == FileEncoding::Ascii) rows.back() = '\n';
    if (rows.size() < kBufferBytes) continue;
    file.write(rows);
    rows.clear();
  }
  file.write(rows);
}

}  // namespace augicp
