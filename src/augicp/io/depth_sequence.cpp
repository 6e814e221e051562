// SPDX-License-Identifier: MIT
#include "augicp/io/depth_sequence.h"

#include <stdexcept>
#include <utility>

#include "augicp/core/check.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/camera_file.h"
#include "augicp/io/depth_file.h"
#include "augicp/io/sequence_folders.h"
#include "augicp/io/stamp_unit.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/io/transform_file.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

constexpr double kTumDepthScale = 5000.0;
constexpr double kUsualDepthScale = 1000.0;
constexpr const char* kSevenScenesEnding = ".depth.png";

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// A damaged truth does not prevent tracking.
void read_truth(const fs::path& folder, DepthSequence& sequence) {
  const fs::path path = folder / "groundtruth.txt";
  if (!is_there(path)) return;
  try {
    TrajectoryFile file = read_tum_trajectory(path);
    sequence.truth = std::move(file.trajectory);
    for (const std::string& warning : file.warnings) sequence.warnings.push_back(path.string() + ": " + warning);
  } catch (const IoError& error) {
    sequence.truth_problem = error.what();
  }
}

std::optional<Rigid3> pose_in(const fs::path& file) {
  try {
    return read_transform(file);
  } catch (const IoError&) {
    return std::nullopt;
  }
}

// 7-Scenes has a pose, as a matrix, beside each image; its authors wrote "-1.#IND" if tracking was lost.
std::optional<Trajectory> seven_scenes_truth(const std::vector<DepthFrameFile>& frames) {
  Trajectory truth;
  for (const DepthFrameFile& frame : frames) {
    const std::string image = frame.path.string();
    const fs::path pose = image.substr(0, image.size() - std::string_view(kSevenScenesEnding).size()) + ".pose.txt";
    if (const auto world_from_camera = pose_in(pose)) truth.push_back({frame.stamp_s, *world_from_camera});
  }
  return truth.empty() ? std::nullopt : std::optional(truth);
}

// A camera file in the folder replaces the layout's camera. A damaged file does not stop users who give the camera
// themselves.
void read_camera_in(const fs::path& folder, DepthSequence& sequence) {
  for (const char* name : {"camera.json", "camera.txt", "camera-intrinsics.txt"}) {
    if (!is_there(folder / name)) continue;
    sequence.camera.reset();
    try {
      sequence.camera = read_camera((folder / name).string());
    } catch (const IoError& error) {
      sequence.camera_problem = error.what();
    }
    return;
  }
}

void bring_into_seconds(const fs::path& list, DepthSequence& sequence) {
  std::vector<double> stamps;
  for (const DepthFrameFile& frame : sequence.frames) stamps.push_back(frame.stamp_s);
  try {
    if (const std::string sentence = augicp::bring_into_seconds(stamps); !sentence.empty())
      sequence.warnings.push_back(list.string() + ": " + sentence);
  } catch (const std::invalid_argument& error) {
    throw io_error(list, error.what());
  }
  for (std::size_t i = 0; i < stamps.size(); ++i) sequence.frames[i].stamp_s = stamps[i];
}

DepthSequence tum_sequence(const fs::path& folder) {
  DepthSequence sequence;
  sequence.layout = "TUM";
  sequence.frames = parse_image_list(read_bytes(folder / "depth.txt"));
  bring_into_seconds(folder / "depth.txt", sequence);
  sequence.depth_scale = kTumDepthScale;
  read_truth(folder, sequence);
  return sequence;
}

DepthSequence seven_scenes_sequence(std::vector<DepthFrameFile> frames) {
  DepthSequence sequence;
  sequence.layout = "7-Scenes";
  sequence.frames = std::move(frames);
  sequence.depth_scale = kUsualDepthScale;
  sequence.camera = camera_by_name("7scenes");
  sequence.truth = seven_scenes_truth(sequence.frames);
  return sequence;
}

}  // namespace

DepthSequence read_depth_sequence(const fs::path& folder, double frames_per_s) {
  require_positive("frames_per_s", frames_per_s);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) throw io_error(folder, "expected a folder of depth images");
  DepthSequence sequence;
  if (is_there(folder / "depth.txt")) {
    sequence = tum_sequence(folder);
  } else if (auto frames = numbered_files(folder, kSevenScenesEnding, frames_per_s); !frames.empty()) {
    sequence = seven_scenes_sequence(std::move(frames));
  } else {
    const fs::path images = fs::is_directory(folder / "depth", ignored) ? folder / "depth" : folder;
    sequence.layout = "numbered";
    NumberedImages found = numbered_images(images, frames_per_s);
    sequence.frames = std::move(found.frames);
    if (!found.left_out.empty()) sequence.warnings.push_back(images.string() + ": " + found.left_out);
    sequence.depth_scale = kUsualDepthScale;
    read_truth(folder, sequence);
  }
  read_camera_in(folder, sequence);
  if (sequence.frames.empty())
    throw io_error(folder,
                   "expected depth.txt, frame-000000.depth.png ... or numbered .png, .pgm, .npy, .pfm or .tif files, "
                   "found no image");
  return sequence;
}

DepthSequence depth_of_topic(const fs::path& bag, const StampedTopic& topic) {
  DepthSequence sequence;
  sequence.layout = "recording";
  sequence.depth_scale = kUsualDepthScale;
  const auto reader = std::make_shared<TopicReader>(bag, topic.name);
  for (std::size_t i = 0; i < topic.stamps_s.size(); ++i)
    sequence.frames.push_back({topic.stamps_s[i], BagMessageName{bag, topic.name, i}.text(), reader, i});
  try {
    sequence.camera = camera_of_topic(bag, topic.name);
  } catch (const IoError& error) {  // it does not stop users who give the camera
    sequence.camera_problem = error.what();
  }
  return sequence;
}

DepthImage read_depth_frame(const DepthFrameFile& frame, double depth_scale) {
  if (!frame.topic) return read_depth_image(frame.path, depth_scale);
  require_positive("depth_scale", depth_scale);
  const BagMessage message = frame.topic->message(frame.message);
  return parse_depth_message(frame.path, message.type, message.data, message.form, depth_scale);
}

DepthSequenceReader::DepthSequenceReader(std::vector<DepthFrameFile> frames, double depth_scale)
    : frames_(std::move(frames)), depth_scale_(depth_scale) {
  require_positive("depth_scale", depth_scale);
}

std::optional<DepthFrame> DepthSequenceReader::next() {
  if (next_ == frames_.size()) return std::nullopt;
  const DepthFrameFile& file = frames_[next_++];
  DepthFrame frame{file.stamp_s, {}, {}};
  try {
    frame.image = read_depth_frame(file, depth_scale_);
  } catch (const IoError& error) {
    frame.problem = error.what();
    return frame;
  }
  if (!scale_is_checked_ && tells_depth_scale(frame.image)) {
    check_depth_scale(frame.image, file.path, depth_scale_);
    scale_is_checked_ = true;
  }
  return frame;
}

}  // namespace augicp
