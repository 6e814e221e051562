// SPDX-License-Identifier: MIT
#include "benchmarks/peers/common/input.h"

#include "augicp/io/depth_png.h"
#include "augicp/io/read_cloud.h"

namespace augicp::peers {
namespace {

Input read_input(const std::filesystem::path& path, const Job& job) {
  if (job.camera) {
    DepthImage image = rectify(read_depth_png(path, job.depth_scale), *job.camera);
    return {unproject(image, job.camera->pinhole).cloud, std::move(image)};
  }
  Cloud cloud = read_cloud(path).cloud;
  // Peers know no origin, and their points are float.
  if (!cloud.origin.isZero()) throw io_error(path, "its points lie too far from zero for peers");
  return {std::move(cloud), std::nullopt};
}

}  // namespace

InputReader::Shared InputReader::read_or_keep(const std::filesystem::path& path, const Job& job) const {
  for (const Kept& kept : {source_, target_})
    if (kept.input && kept.path == path) return kept.input;
  return std::make_shared<const Input>(read_input(path, job));
}

std::pair<InputReader::Shared, InputReader::Shared> InputReader::read(const Job& job) {
  Shared source = read_or_keep(job.source, job), target = read_or_keep(job.target, job);
  source_ = {job.source, source};
  target_ = {job.target, target};
  return {std::move(source), std::move(target)};
}

}  // namespace augicp::peers
