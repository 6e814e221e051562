// SPDX-License-Identifier: MIT
// Sequences of depth images: folders, and topics of recordings.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "augicp/geometry/trajectory.h"
#include "augicp/sensor/depth_camera.h"
#include "augicp/sensor/frame_source.h"

namespace augicp {

class TopicReader;

struct DepthFrameFile {
  double stamp_s = 0.0;
  std::filesystem::path path;            // of a recording: the name of the message
  std::shared_ptr<TopicReader> topic{};  // of a recording alone, shared by its frames
  std::size_t message = 0;               // number in the topic
};

struct DepthSequence {
  std::string layout;                  // "TUM", "7-Scenes", "numbered" or "recording"
  std::vector<DepthFrameFile> frames;  // in the order of the list or of the numbers; stamps unchanged
  double depth_scale = 0.0;            // default of the layout: TUM 5000, others 1000
  std::optional<DepthCamera> camera;   // from a file camera.json, camera.txt or camera-intrinsics.txt, or the layout's
  std::string camera_problem;          // why there is no camera although there is such a file
  std::optional<Trajectory> truth;     // world_from_camera
  std::string truth_problem;           // why there is no truth although there is a groundtruth.txt
  std::vector<std::string> warnings;   // images left out, stamps in other units; each names its file
};

// The content of a folder with one of these layouts:
//   TUM        depth.txt with lines "stamp path", paths relative to the folder; optionally groundtruth.txt
//   7-Scenes   frame-000000.depth.png ...; optionally the poses frame-000000.pose.txt
//   numbered   1.png, 2.png ... or any names that end in a number, in the folder or in its folder depth/;
//              optionally groundtruth.txt.
//              A number with a decimal point (1305031453.374112.png) is a stamp in seconds
// If a folder has numbered images of several kinds, only the first kind is read; a warning counts the others.
// Frames without stamps get their number / frames_per_s. Stamps of a list in other units than seconds: see
// bring_into_seconds(). Images are not opened. Throws IoError if the folder has none of these layouts, if its list of
// images is damaged or in no unit that suits, and std::invalid_argument unless frames_per_s is above 0.
DepthSequence read_depth_sequence(const std::filesystem::path& folder, double frames_per_s = kUsualFramesPerS);

struct StampedTopic;

// The depth images of a topic of a recording, with the camera of its CameraInfo. Its messages are best read in
// ascending order, by one thread at a time. Throws IoError.
DepthSequence depth_of_topic(const std::filesystem::path& bag, const StampedTopic& topic);

// One frame of a sequence. Throws IoError, and std::invalid_argument unless depth_scale is above 0.
DepthImage read_depth_frame(const DepthFrameFile& frame, double depth_scale);

// Reads the frames of a list one by one, on demand. An image that cannot be read becomes a frame with a problem. A
// depth scale that is wrong by a factor throws IoError (see check_depth_scale); it is judged by the first image with
// readings in more than a hundredth of its pixels.
class DepthSequenceReader : public FrameSource {
 public:
  // Throws std::invalid_argument unless depth_scale is above 0.
  DepthSequenceReader(std::vector<DepthFrameFile> frames, double depth_scale);
  std::optional<DepthFrame> next() override;

 private:
  std::vector<DepthFrameFile> frames_;
  double depth_scale_;
  std::size_t next_ = 0;
  bool scale_is_checked_ = false;
};

}  // namespace augicp
