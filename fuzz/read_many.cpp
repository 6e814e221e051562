// SPDX-License-Identifier: MIT
// Reads files handed over on standard input, and says of each what was read: for tests/hostile_files.py, to which a
// process a file would cost a thousand times more. Every file is "EXTENSION LENGTH\n" and its bytes, every answer a
// line:
//   read KEPT DROPPED WARNINGS SUM     points, poses, pixels or numbers; SUM of the sizes of their coordinates
//   refused MESSAGE
//   failed MESSAGE                     something else was thrown
// A file that takes more than a second of the processor's time ends the program, as a crash does. With --limit-memory
// so much is granted as the promise says: 64 MB and three times the file above what the program has when it starts.
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>

#include "augicp/io/atomic_file.h"
#include "augicp/io/bag.h"
#include "augicp/io/camera_file.h"
#include "augicp/io/depth_file.h"
#include "augicp/io/format.h"
#include "augicp/io/grey_png.h"
#include "augicp/io/pose_file.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/ros_image.h"
#include "augicp/io/sequence_folders.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/io/transform_file.h"
#include "augicp/testing/temporary_folder.h"
#include "fuzz/promises.h"

namespace {

using namespace augicp;

struct Content {
  std::size_t num_kept = 0, num_dropped = 0, num_warnings = 0;
  double sum = 0.0;
};

double size_of(const Vec3d& x) { return x.cwiseAbs().sum(); }

Content read_points(const FileBytes& file, const ReadOptions& options = {}) {
  const CloudFile read = parse_cloud(file, options);
  fuzz::expect_sound(read);
  Content content{read.cloud.size(), read.report.num_not_finite, read.report.warnings.size()};
  for (const Vec3f& point : read.cloud.points) content.sum += size_of(read.cloud.origin + point.cast<double>());
  return content;
}

// extension: the one that users have.
Content read_depth(const FileBytes& file, const char* extension) {
  const DepthImage image = parse_depth_image({file.path.string() + extension, file.bytes}, 1000.0);
  Content content;
  for (const float depth : image.depth) {
    ++(std::isnan(depth) ? content.num_dropped : content.num_kept);
    if (!std::isnan(depth)) content.sum += static_cast<double>(depth);
  }
  return content;
}

Content read_grey(const FileBytes& file) {
  Content content;
  for (const float value : parse_grey_png(file).value) {
    ++content.num_kept;
    content.sum += static_cast<double>(value);
  }
  return content;
}

Content read_list(const FileBytes& file) {
  Content content;
  for (const DepthFrameFile& frame : parse_image_list(file)) {
    ++content.num_kept;
    content.sum += std::abs(frame.stamp_s);
  }
  return content;
}

Content content_of(const TrajectoryFile& read) {
  fuzz::expect_sound(read.trajectory);
  Content content{read.trajectory.size(), 0, read.warnings.size()};
  for (const StampedPose& pose : read.trajectory) content.sum += size_of(pose.world_from_camera.translation);
  return content;
}

Content read_transform(const FileBytes& file) {
  const Rigid3 pose = parse_transform(file.bytes);
  fuzz::expect_rigid(pose);
  return {1, 0, 0, size_of(pose.translation)};
}

Content read_camera(const FileBytes& file) {
  const Pinhole pinhole = parse_camera(file).pinhole;
  return {1, 0, 0, pinhole.fx + pinhole.fy + std::abs(pinhole.cx) + std::abs(pinhole.cy)};
}

// Messages, and the sum of their lengths. Recordings are read from files alone.
Content read_recording(const FileBytes& file) {
  write_file(file.path, file.bytes);
  Content content;
  visit_messages(file.path, [&](const BagMessage& message) {
    ++content.num_kept;
    content.sum += static_cast<double>(message.data.size());
    return true;
  });
  return content;
}

// The first byte chooses the form, and of depth messages the type, as in fuzz/.
Content read_message(const FileBytes& file) {
  const int choice = file.bytes.empty() ? 0 : static_cast<std::uint8_t>(file.bytes.front());
  const std::string_view bytes = std::string_view(file.bytes).substr(file.bytes.empty() ? 0 : 1);
  const MessageForm form = choice % 2 == 0 ? MessageForm::Cdr : MessageForm::Ros1;
  Content content;
  if (file.path.extension() == ".point_cloud2") {
    const CloudFile read = parse_point_cloud2(file.path, bytes, form, {}).file;
    fuzz::expect_sound(read);
    content.num_kept = read.cloud.size();
  } else if (choice / 2 % 3 == 2) {
    parse_camera_info(file.path, bytes, form, choice >= 128);
    content.num_kept = 1;
  } else {
    const char* type = choice / 2 % 3 == 0 ? kImage : kCompressedImage;
    content.num_kept = parse_depth_message(file.path, type, bytes, form, 1000.0).depth.size();
  }
  return content;
}

Content read_mesh(const FileBytes& file) {
  ReadOptions options;
  options.sample_faces = true;
  return read_points({"any.ply_mesh.ply", file.bytes}, options);
}

Content read(const FileBytes& file) {
  const std::string kind = file.path.extension().string();
  if (kind == ".ply_mesh") return read_mesh(file);
  if (kind == ".mcap" || kind == ".bag" || kind == ".db3") return read_recording(file);
  if (kind == ".point_cloud2" || kind == ".depth_message") return read_message(file);
  if (kind == ".depth_png") return read_depth(file, ".png");
  if (kind == ".depth_pgm") return read_depth(file, ".pgm");
  if (kind == ".depth_npy") return read_depth(file, ".npy");
  if (kind == ".depth_pfm") return read_depth(file, ".pfm");
  if (kind == ".depth_tiff") return read_depth(file, ".tif");
  if (kind == ".grey_png") return read_grey(file);
  if (kind == ".image_list") return read_list(file);
  if (kind == ".trajectory") return content_of(parse_tum_trajectory(file));
  if (kind == ".poses") return content_of(parse_poses({file.path.string() + ".csv", file.bytes}).content);
  if (kind == ".transform") return read_transform(file);
  if (kind == ".camera") return read_camera(file);
  return read_points(file);
}

std::string answer(const FileBytes& file) {
  try {
    const Content content = read(file);
    return fmt::format("read {} {} {} {}", content.num_kept, content.num_dropped, content.num_warnings, content.sum);
  } catch (const IoError& error) {
    return fmt::format("refused {}", error.what());
  } catch (const std::invalid_argument& error) {
    return fmt::format("{} {}", file.path.extension() == ".transform" ? "refused" : "failed", error.what());
  } catch (const std::exception& error) {
    return fmt::format("failed {}", error.what());
  }
}

rlim_t bytes_in_use() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit_memory(rlim_t num_bytes) {
  const rlimit limit{num_bytes, RLIM_INFINITY};
  setrlimit(RLIMIT_AS, &limit);
}

// SIGPROF ends the program.
void limit_time() {
  const itimerval one_second{{0, 0}, {1, 0}};
  setitimer(ITIMER_PROF, &one_second, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr rlim_t kGranted = 64 << 20;
  const bool limits_memory = argc > 1 && std::string_view(argv[1]) == "--limit-memory";
  const testing::TemporaryFolder folder;
  std::filesystem::current_path(folder.path());
  const rlim_t idle = bytes_in_use();
  std::string extension;
  std::size_t length = 0;
  while (std::cin >> extension >> length && std::cin.get() == '\n') {
    FileBytes file{"any" + extension, std::string(length, '\0')};
    std::cin.read(file.bytes.data(), static_cast<std::streamsize>(length));
    if (limits_memory) limit_memory(idle + kGranted + 3 * length);
    limit_time();
    std::cout << answer(file) << std::endl;
  }
}
