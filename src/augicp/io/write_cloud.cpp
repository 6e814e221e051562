// SPDX-License-Identifier: MIT
#include "augicp/io/write_cloud.h"

#include <string>

#include "augicp/io/atomic_file.h"
#include "augicp/io/cloud_rows.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

const char* ply_type(ScalarType type) {
  switch (type) {
    case ScalarType::Float64:
      return "double";
    case ScalarType::Uint8:
      return "uchar";
    default:
      return "float";
  }
}

std::string pcd_header(const Cloud& cloud, FileEncoding encoding) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const RowColumn& column : row_columns(cloud, {})) {
    fields += fmt::format(" {}{}", column.name[0] == 'n' ? "normal_" : "", column.name + (column.name[0] == 'n'));
    sizes += fmt::format(" {}", num_bytes(column.type));
    types += column.type == ScalarType::Uint8 ? " U" : " F";
    counts += " 1";
  }
  const Vec3d viewpoint = cloud.viewpoint ? Vec3d(cloud.origin + cloud.viewpoint->cast<double>()) : Vec3d(0, 0, 0);
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n{}\n{}\n{}\n{}\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT {} {} {} 1 0 0 0\nPOINTS {}\nDATA {}\n",
      fields, sizes, types, counts, cloud.size(), viewpoint.x(), viewpoint.y(), viewpoint.z(), cloud.size(),
      encoding == FileEncoding::Ascii ? "ascii" : "binary");
}

}  // namespace

void write_ply(const std::filesystem::path& path, const Cloud& cloud, std::span<const Colour> colours,
               FileEncoding encoding) {
  std::string header = fmt::format("ply\nformat {} 1.0\nelement vertex {}\n",
                                   encoding == FileEncoding::Ascii ? "ascii" : "binary_little_endian", cloud.size());
  for (const RowColumn& column : row_columns(cloud, colours))
    header += fmt::format("property {} {}\n", ply_type(column.type), column.name);
  AtomicFile file(path);
  file.write(header + "end_header\n");
  write_rows(file, cloud, colours, encoding);
  file.commit();
}

void write_pcd(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding) {
  const std::string header = pcd_header(cloud, encoding);
  AtomicFile file(path);
  file.write(header);
  write_rows(file, cloud, {}, encoding);
  file.commit();
}

void write_cloud(const std::filesystem::path& path, const Cloud& cloud) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".ply") return write_ply(path, cloud);
  if (extension == ".pcd") return write_pcd(path, cloud);
  throw io_error(path, "expected the extension .ply or .pcd, found " + in_quotes(extension));
}

}  // namespace augicp
