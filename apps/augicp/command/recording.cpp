// SPDX-License-Identifier: MIT
#include "apps/augicp/command/recording.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "apps/augicp/command/interruption.h"
#include "augicp/core/error.h"
#include "augicp/geometry/rotation.h"
#include "augicp/io/mcap_writer.h"
#include "augicp/trust/covariance.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

constexpr int kLeastColumns = 160;

// A pose between two frames, as /tf and /odometry.
class PoseTopics {
 public:
  PoseTopics(McapWriter& writer, std::string parent, std::string child)
      : writer_(writer),
        parent_(std::move(parent)),
        child_(std::move(child)),
        tf_(writer.add_topic("/tf", tf_type())),
        odometry_(writer.add_topic("/odometry", odometry_type())) {}

  void write(std::int64_t stamp_ns, const Rigid3& pose, const std::optional<Mat6d>& covariance,
             const Twist& twist = {}) {
    writer_.write(tf_, stamp_ns, tf_message({stamp_ns, parent_}, child_, pose));
    writer_.write(odometry_, stamp_ns, odometry_message({stamp_ns, parent_}, child_, pose, covariance, twist));
  }

 private:
  McapWriter& writer_;
  std::string parent_, child_;
  std::uint16_t tf_, odometry_;
};

class CloudTopic {
 public:
  CloudTopic(McapWriter& writer, const char* topic, std::string frame)
      : writer_(writer), frame_(std::move(frame)), topic_(writer.add_topic(topic, point_cloud2_type())) {}

  void write(std::int64_t stamp_ns, const CloudFile& file) {
    writer_.write(topic_, stamp_ns, point_cloud2_message({stamp_ns, frame_}, file));
  }

 private:
  McapWriter& writer_;
  std::string frame_;
  std::uint16_t topic_;
};

std::int64_t nanoseconds(double stamp_s) { return std::llround(stamp_s * 1e9); }

// A report's covariance is about the place of the last keyframe before it; of a recording it is about the sensor.
class CovarianceAtSensor {
 public:
  std::optional<Mat6d> of(const FrameReport& report) {
    std::optional<Mat6d> covariance;
    const Vec3d& place = report.world_from_camera.translation;
    if (report.covariance) covariance = covariance_about(*report.covariance, place - keyframe_);
    if (report.is_keyframe) keyframe_ = place;
    return covariance;
  }

 private:
  Vec3d keyframe_ = Vec3d::Zero();
};

// The nearest row with a pose of the same segment, in this direction; the row itself if there is none.
std::size_t neighbour(const std::vector<FrameRow>& rows, std::size_t row, int direction) {
  for (std::size_t i = row + direction; i < rows.size(); i += direction)  // below 0 it is beyond the size
    if (has_pose(rows[i].report.status)) return rows[i].report.segment == rows[row].report.segment ? i : row;
  return row;
}

// The motion from the pose before to the one behind, as an even one; zero if there is neither.
Twist twist_at(const std::vector<FrameRow>& rows, std::size_t row) {
  const FrameReport &before = rows[neighbour(rows, row, -1)].report, &behind = rows[neighbour(rows, row, 1)].report;
  const double duration_s = behind.stamp_s - before.stamp_s;
  if (!(duration_s > 0.0)) return {};
  const Rigid3 &first = before.world_from_camera, &last = behind.world_from_camera;
  const Eigen::Quaterniond sensor_from_world = rows[row].report.world_from_camera.rotation.conjugate();
  return {sensor_from_world * (last.translation - first.translation) / duration_s,
          rotation_log(first.rotation.conjugate() * last.rotation) / duration_s};
}

void write_scan(CloudTopic& topic, std::int64_t stamp_ns, const FrameRow& row,
                const std::function<CloudFile(const FrameRow&)>& cloud_of) {
  std::optional<CloudFile> file;
  try {
    file = cloud_of(row);
  } catch (const IoError&) {  // it was readable when it was tracked; the pose is right without its points
    return;
  }
  if (!file->cloud.empty()) topic.write(stamp_ns, *file);
}

}  // namespace

void add_mcap_option(CLI::App& command, std::string& path) {
  command.add_option("--mcap", path, "Write clouds, transforms and odometry for Foxglove, rerun and ros2 bag play")
      ->group("Output");
}

void write_odometry_mcap(const fs::path& path, const OdometryRun& run, const Cloud& map,
                         const std::function<CloudFile(const FrameRow&)>& cloud_of) {
  write_whole([&] {
    McapWriter writer(path);
    PoseTopics poses(writer, "map", "sensor");
    CloudTopic points(writer, "/points", "sensor");
    CovarianceAtSensor covariance;
    // At the front, so that players show it from the beginning.
    if (!map.empty())
      CloudTopic(writer, "/map", "map").write(nanoseconds(run.rows.front().report.stamp_s), {map, std::nullopt, {}});
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
      const FrameRow& row = run.rows[i];
      if (!has_pose(row.report.status)) continue;
      const std::int64_t stamp_ns = nanoseconds(row.report.stamp_s);
      poses.write(stamp_ns, row.report.world_from_camera, covariance.of(row.report), twist_at(run.rows, i));
      write_scan(points, stamp_ns, row, cloud_of);
    }
    writer.commit();
  });
}

void write_depth_mcap(const fs::path& path, const OdometryRun& run, const DepthSequence& sequence,
                      const DepthCamera& camera, double depth_scale) {
  const int step = std::max(1, camera.pinhole.width / kLeastColumns);
  write_odometry_mcap(path, run, {}, [&](const FrameRow& row) {
    const DepthImage image = read_depth_frame(sequence.frames[row.frame], depth_scale);
    return CloudFile{unproject(rectify(image, camera, step), thinned(camera.pinhole, step)).cloud, std::nullopt, {}};
  });
}

void write_align_mcap(const fs::path& path, const AlignReport& report, const CloudFile& moved,
                      const CloudFile& target) {
  const Rigid3& pose = report.result.target_from_source;
  std::optional<Mat6d> covariance;
  if (report.result.covariance)
    covariance = covariance_about(*report.result.covariance, pose.translation - report.reference_point);
  write_whole([&] {
    McapWriter writer(path);
    PoseTopics(writer, "target", "source").write(0, pose, covariance);
    CloudTopic(writer, "/target", "target").write(0, target);
    CloudTopic(writer, "/source", "target").write(0, moved);
    writer.commit();
  });
}

}  // namespace augicp::app
