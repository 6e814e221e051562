// SPDX-License-Identifier: MIT
#include "augicp/io/read_cloud.h"

#include <string>
#include <string_view>

#include "augicp/io/bag.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/format.h"
#include "augicp/io/read_kitti.h"
#include "augicp/io/read_las.h"
#include "augicp/io/read_mesh.h"
#include "augicp/io/read_npy.h"
#include "augicp/io/read_pcd.h"
#include "augicp/io/read_ply.h"
#include "augicp/io/read_xyz.h"

namespace augicp {
namespace {

struct Format {
  std::string_view extension;
  CloudFile (*parse)(const FileBytes&, const ReadOptions&);
};

constexpr Format kFormats[] = {
    {".ply", parse_ply},    {".pcd", parse_pcd},   {".las", parse_las}, {".laz", parse_las}, {".xyz", parse_xyz},
    {".txt", parse_xyz},    {".csv", parse_xyz},   {".pts", parse_xyz}, {".asc", parse_xyz}, {".xyzn", parse_xyz},
    {".xyzrgb", parse_xyz}, {".bin", parse_kitti}, {".npy", parse_npy}, {".stl", parse_stl}, {".obj", parse_obj},
    {".glb", parse_gltf},   {".gltf", parse_gltf}};

struct Advice {
  std::string_view extensions, advice;  // the extensions with a blank behind each
};

// Formats that people have, and how to make one that is read.
constexpr Advice kAdvice[] = {
    {".e57 .ptx .copc ", "pdal translate IN OUT.ply, or CloudCompare's export"},
    {".pcap .pcapng ", "packets of a LiDAR: its maker's program exports clouds or a bag"},
    {".zstd .zst ", "zstd -d FILE"},
    {".gz .tgz ", "gunzip FILE"},
    {".zip .7z .tar ", "unpack it"},
    {".npz .h5 .hdf5 .mat .pkl .pickle .feather .parquet .pt ",
     "the Python module takes arrays: augicp.align(source, target)"},
    {".off .vtk .vtp .vtu .dae .fbx .3ds .3mf .wrl .x3d .drc .usd .usdz ", "export it as .ply or .obj"},
    {".step .stp .iges .igs .blend .ifc ", "export its surface as .stl or .ply"},
    {".jpg .jpeg ", "depth images are 16-bit .png; a .jpg has lost its depths"}};

std::string advice_for(std::string_view extension) {
  const std::string word = std::string(extension) + ' ';
  for (const Advice& known : kAdvice)
    if (word.size() > 1 && known.extensions.find(word) != std::string_view::npos)
      return "; " + std::string(known.advice);
  return {};
}

const Format& format_of(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  std::string known;
  for (const Format& format : kFormats) {
    if (format.extension == extension) return format;
    known += ' ';
    known += format.extension;
  }
  throw io_error(path, fmt::format("expected a cloud with one of the extensions{}, found {}{}", known,
                                   extension.empty() ? "none" : in_quotes(extension), advice_for(extension)));
}

CloudFile read_message(const BagMessageName& name, const ReadOptions& options) {
  const std::string clouds[] = {kPointCloud2};
  const std::string topic = name.topic.empty() ? chosen_topic(name.bag, {}, clouds).name : name.topic;
  TopicReader reader(name.bag, topic);
  return parse_cloud_message(name.text(), reader.message(name.number), options);
}

[[noreturn]] void refuse_recording(const std::filesystem::path& path) {
  const BagReader exists(path);
  throw io_error(path, fmt::format("is a recording, expected one cloud; the first of its clouds is {}",
                                   BagMessageName{path, {}, 0}.text()));
}

}  // namespace

CloudFile parse_cloud(const FileBytes& file, const ReadOptions& options) {
  return format_of(file.path).parse(file, options);
}

CloudFile read_cloud(const std::filesystem::path& path, const ReadOptions& options) {
  if (const auto name = parse_bag_message_name(path)) return read_message(*name, options);
  if (is_bag(path)) refuse_recording(path);
  const Format& format = format_of(path);
  return format.parse(read_bytes(path), options);
}

}  // namespace augicp
