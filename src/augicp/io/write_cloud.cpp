// SPDX-License-Identifier: MIT
#include "augicp/io/write_cloud.h"

#include <stdexcept>

#include "augicp/io/atomic_file.h"
#include "augicp/io/cloud_rows.h"
#include "augicp/io/field_layout.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/write_las.h"

namespace augicp {
namespace {

// REQUIRES: not an integer of 64 bits.
const char* ply_type(ScalarType type) {
  constexpr const char* kNames[] = {"char", "uchar", "short", "ushort", "int", "uint", "", "", "float", "double"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string pcd_name(const std::string& name) {
  const bool is_normal = name == "nx" || name == "ny" || name == "nz";
  return is_normal ? "normal_" + name.substr(1) : name;
}

char pcd_type(ScalarType type) {
  if (is_floating(type)) return 'F';
  return static_cast<int>(type) % 2 == 0 ? 'I' : 'U';  // signed and unsigned take turns
}

std::string pcd_header(const Cloud& cloud, const IndexImage* grid, const std::vector<RowColumn>& columns,
                       FileEncoding encoding) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const RowColumn& column : columns) {
    fields += ' ' + pcd_name(column.name);
    sizes += fmt::format(" {}", num_bytes(column.type));
    types += fmt::format(" {}", pcd_type(column.type));
    counts += fmt::format(" {}", column.count);
  }
  const Vec3d viewpoint = cloud.viewpoint ? Vec3d(cloud.origin + cloud.viewpoint->cast<double>()) : Vec3d(0, 0, 0);
  const std::size_t width = grid ? static_cast<std::size_t>(grid->width) : cloud.size();
  const std::size_t height = grid ? static_cast<std::size_t>(grid->height) : 1;
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n{}\n{}\n{}\n{}\nWIDTH {}\nHEIGHT {}\n"
      "VIEWPOINT {} {} {} 1 0 0 0\nPOINTS {}\nDATA {}\n",
      fields, sizes, types, counts, width, height, viewpoint.x(), viewpoint.y(), viewpoint.z(), width * height,
      encoding == FileEncoding::Ascii ? "ascii" : "binary");
}

void write_ply_file(const std::filesystem::path& path, const Cloud& cloud, const PointFields& fields,
                    FileEncoding encoding) {
  std::string header = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n",
                                   encoding == FileEncoding::Ascii ? "ascii" : "binary_little_endian", cloud.size());
  const std::vector<RowPart> parts = row_parts(cloud, fields, nullptr, encoding);
  for (const RowColumn& column : columns_of(parts))
    header += fmt::format("property {} {}\n", ply_type(column.type), column.name);
  AtomicFile file(path);
  file.write(header + "end_header\n");
  write_rows(file, parts, cloud.size(), nullptr, encoding);
  file.commit();
}

void write_pcd_file(const std::filesystem::path& path, const Cloud& cloud, const PointFields& fields,
                    const IndexImage* grid, FileEncoding encoding) {
  const std::vector<RowPart> parts = row_parts(cloud, fields, grid, encoding);
  const std::string header = pcd_header(cloud, grid, columns_of(parts), encoding);
  AtomicFile file(path);
  file.write(header);
  write_rows(file, parts, cloud.size(), grid, encoding);
  file.commit();
}

PointFields fields_without_grid(const CloudFile& file) {
  if (!file.grid) return fields_of(file);
  PointFields fields = without_empty_cells(file.fields, *file.grid);
  fields.not_kept.push_back(
      fmt::format("the grid of {} x {} cells: PLY has none", file.grid->width, file.grid->height));
  return fields;
}

std::string checked_extension(const std::filesystem::path& path) {
  std::string extension = lower_case_extension(path);
  if (extension == ".ply" || extension == ".pcd" || extension == ".las") return extension;
  throw io_error(path, "expected the extension .ply, .pcd or .las, found " + in_quotes(extension));
}

}  // namespace

std::vector<PointField> colour_fields(std::span<const Colour> colours) {
  std::vector<PointField> fields{
      {"red", ScalarType::Uint8, 1, {}}, {"green", ScalarType::Uint8, 1, {}}, {"blue", ScalarType::Uint8, 1, {}}};
  for (const Colour& colour : colours)
    for (std::size_t i = 0; i < fields.size(); ++i) fields[i].values.push_back(static_cast<char>(colour[i]));
  return fields;
}

void write_ply(const std::filesystem::path& path, const Cloud& cloud, std::span<const Colour> colours,
               FileEncoding encoding) {
  PointFields fields;
  if (!colours.empty()) fields.fields = colour_fields(colours);
  write_ply_file(path, cloud, fields, encoding);
}

void write_pcd(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding) {
  write_pcd_file(path, cloud, {}, nullptr, encoding);
}

std::vector<std::string> write_cloud(const std::filesystem::path& path, const CloudFile& file) {
  const std::string extension = checked_extension(path);
  if (extension == ".las") return write_las(path, file);
  const bool is_pcd = extension == ".pcd";
  const PointFields fields = is_pcd ? fields_for_pcd(fields_of(file)) : fields_for_ply(fields_without_grid(file));
  if (is_pcd) {
    write_pcd_file(path, file.cloud, fields, file.grid ? &*file.grid : nullptr, FileEncoding::Binary);
  } else {
    write_ply_file(path, file.cloud, fields, FileEncoding::Binary);
  }
  return fields.not_kept;
}

void write_cloud(const std::filesystem::path& path, const Cloud& cloud) {
  const std::string extension = checked_extension(path);
  if (extension == ".las") {
    write_las(path, {cloud, std::nullopt, {}});
  } else if (extension == ".ply") {
    write_ply(path, cloud);
  } else {
    write_pcd(path, cloud);
  }
}

}  // namespace augicp
