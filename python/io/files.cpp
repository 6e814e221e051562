// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "augicp/io/camera_file.h"
#include "augicp/io/depth_file.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/transform_file.h"
#include "augicp/io/write_cloud.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/errors.h"
#include "python/core/numbers.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"
#include "python/sensor/camera.h"

namespace augicp::python {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFilesReadDoc =
    R"(The Cloud in a file: .ply, .pcd, .las, .laz (with laspy), .xyz .txt .csv .pts .asc, KITTI's .bin, .npy, .stl, .obj, .glb,
.gltf, or a depth image (see read_depth; .npy with camera); or one cloud of a recording (.bag, .db3, .mcap, or a folder of rosbag2): "drive.mcap#12" is the one with number 12, from 0, and
"drive.mcap#/points#12" that of a topic.

camera, depth_scale: of a depth image, see Cloud.from_depth. A camera's name brings its depth_scale, and floats need none.
bin_columns: numbers a point in a .bin file: 3, 4 (x y z intensity), 5 or 6; 0: 4 to 6, found by the numbers. max_points: files with more are refused.

Points that are not finite are dropped. Raises FileError, with nothing read, for a file that is damaged, cut short or without
points. A suspicious file is a UserWarning.)";

// That of a named camera; of formats that may have floats, metres.
std::optional<double> usual_scale(const fs::path& path, const py::object& camera) {
  constexpr double kMetres = 1.0;
  if (py::isinstance<py::str>(camera))
    if (const auto named = depth_scale_of_camera(camera.cast<std::string>())) return named;
  const std::string extension = lower_case_extension(path);
  return extension == ".png" || extension == ".pgm" ? std::nullopt : std::optional(kMetres);
}

ColouredScan read_image(const fs::path& path, const py::object& camera, std::optional<double> depth_scale) {
  const std::optional<double> scale = depth_scale ? depth_scale : usual_scale(path, camera);
  if (camera.is_none() || !scale) throw WrongType(path.string() + ": a depth image needs camera and depth_scale");
  const DepthCamera seen_by = camera_from(camera);
  return without_gil([&](const std::stop_token&) {
    const DepthImage image = read_depth_image(path, *scale);
    check_depth_scale(image, path, *scale);
    return ColouredScan(scan_of(image, seen_by));
  });
}

// The bytes of a LAZ file as LAS, by laspy.
FileBytes decompressed(const fs::path& path) {
  try {
    const py::object buffer = py::module_::import("io").attr("BytesIO")();
    const py::object las = py::module_::import("laspy").attr("read")(path.string());
    las.attr("write")(buffer, py::arg("do_compress") = false);
    return {path, buffer.attr("getvalue")().cast<std::string>()};
  } catch (const py::error_already_set& error) {
    if (error.matches(PyExc_ImportError)) throw io_error(path, "LAZ is read through laspy: pip install laspy[lazrs]");
    throw io_error(path, error.what());
  }
}

CloudFile read_file(const fs::path& path, const ReadOptions& options) {
  // A missing file is one of any name.
  if (lower_case_extension(path) != ".laz" || !fs::exists(path))
    return without_gil_or_wait([path, options](const std::stop_token&) { return read_cloud(path, options); });
  const FileBytes file = decompressed(path);
  return without_gil([&](const std::stop_token&) { return parse_cloud(file, options); });
}

ColouredScan read_scan(const fs::path& path, const py::object& camera, std::optional<double> depth_scale,
                       int bin_columns, std::uint64_t max_points) {
  const bool is_image = is_image_file(path) || (lower_case_extension(path) == ".npy" && !camera.is_none());
  if (is_image) return read_image(path, camera, depth_scale);
  if (!camera.is_none())
    throw std::invalid_argument(path.string() + ": camera goes with a depth image, and this is none");
  const ReadOptions options{max_points, bin_columns, /*keep_fields=*/true};  // for the colours
  CloudFile file = read_file(path, options);
  warn(file.report.warnings, path.string());
  return without_gil([&](const std::stop_token&) { return coloured_scan_of(std::move(file)); });
}

void write(const fs::path& path, const py::object& cloud) {
  const SharedScan scan = scan_from(cloud, "cloud");
  warn(without_gil([&](const std::stop_token&) {
         CloudFile file{scan->cloud, std::nullopt, {}};
         if (!scan->colours.empty()) file.fields.fields = colour_fields(scan->colours);
         return write_cloud(path, file);
       }),
       path.string());
}

void write_matrix(const fs::path& path, const py::object& matrix) {
  const Rigid3 motion = rigid3_from(matrix, "matrix");
  without_gil([&](const std::stop_token&) { write_transform(path, motion); });
}

}  // namespace

void bind_files(py::module_& module) {
  const ReadOptions usual;
  module.def("read", &read_scan, py::arg("path"), py::arg("camera") = py::none(), py::arg("depth_scale") = py::none(),
             py::arg("bin_columns") = usual.num_bin_columns, py::arg("max_points") = usual.max_points, kFilesReadDoc);
  module.def(
      "write", &write, py::arg("path"), py::arg("cloud"),
      "Writes a Cloud or an (N, 3) array as .ply, .pcd or .las, binary, with the directions, structures, intensities "
      "and colours that it has; whole or absent. Raises FileError, and ArgumentError for a cloud without points.");
  module.def(
      "read_transform",
      [](const fs::path& path) {
        return to_array(without_gil([&](const std::stop_token&) { return read_transform(path); }));
      },
      py::arg("path"),
      "The (4, 4) matrix of a rigid motion in a text file: 16 or 12 numbers row by row, or tx ty tz qx qy qz qw. "
      "Raises FileError.");
  module.def("write_transform", &write_matrix, py::arg("path"), py::arg("matrix"),
             "Writes a (4, 4) rigid motion as four lines of four numbers. Raises FileError.");
}

}  // namespace augicp::python
