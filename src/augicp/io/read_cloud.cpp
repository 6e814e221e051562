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

constexpr Format kFormats[] = {{".ply", parse_ply}, {".pcd", parse_pcd}, {".xyz", parse_xyz},   {".txt", parse_xyz},
                               {".csv", parse_xyz}, {".pts", parse_xyz}, {".bin", parse_kitti}, {".npy", parse_npy},
                               {".las", parse_las}, {".laz", parse_las}, {".stl", parse_stl},   {".obj", parse_obj}};

struct Advice {
  std::string_view extension, advice;
};

// Formats that people have, and how to make one that is read.
constexpr Advice kAdvice[] = {{".e57", "pdal translate IN.e57 OUT.ply"},
                              {".asc", "rename it to .xyz"},
                              {".zstd", "zstd -d FILE"},
                              {".zst", "zstd -d FILE"},
                              {".jpg", "depth images are 16-bit .png; a .jpg has lost its depths"}};

std::string advice_for(std::string_view extension) {
  for (const Advice& known : kAdvice)
    if (known.extension == extension) return "; " + std::string(known.advice);
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
  throw io_error(path,
                 "expected one of the extensions" + known + ", found " + in_quotes(extension) + advice_for(extension));
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
