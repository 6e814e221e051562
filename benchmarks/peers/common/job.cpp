// SPDX-License-Identifier: MIT
#include "benchmarks/peers/common/job.h"

#include <array>
#include <stdexcept>

#include "augicp/io/camera_file.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"
#include "augicp/io/transform_file.h"

namespace augicp::peers {
namespace {

constexpr std::string_view kHeader = "pair,source,target,scene,camera,depth_scale,guess";

Job parse_job(std::string_view line) {
  std::array<std::string, 7> fields;
  for (std::string& field : fields) {
    const auto next = next_field(line, ',');
    if (!next) throw std::invalid_argument("expected 7 fields");
    field = *next;
  }
  Job job{fields[0], fields[1], fields[2], fields[3], {}, 0.0, {}};
  if (fields[4] != "-") {
    const auto depth_scale = parse_double(fields[5]);
    if (!depth_scale) throw std::invalid_argument("expected a depth scale, found " + in_quotes(fields[5]));
    job.camera = read_camera(fields[4]);
    job.depth_scale = *depth_scale;
  }
  if (fields[6] != "previous") job.guess = parse_transform(fields[6]);
  return job;
}

}  // namespace

std::vector<Job> read_jobs(const std::filesystem::path& path) {
  const FileBytes file = read_bytes(path);
  TextLines lines(file.bytes);
  if (lines.next() != kHeader) throw io_error_at_line(path, 1, "expected " + in_quotes(kHeader));
  std::vector<Job> jobs;
  while (const auto line = lines.next_not_blank()) {
    try {
      jobs.push_back(parse_job(*line));
    } catch (const std::exception& error) {
      throw io_error_at_line(path, lines.line(), error.what());
    }
  }
  return jobs;
}

}  // namespace augicp::peers
