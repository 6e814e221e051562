// SPDX-License-Identifier: MIT
// Folders of depth images.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "augicp/geometry/trajectory.h"
#include "augicp/sensor/depth_camera.h"
#include "augicp/sensor/frame_source.h"

namespace augicp {

struct DepthFrameFile {
  double stamp_s = 0.0;
  std::filesystem::path path;
};

struct DepthSequence {
  std::string layout;                  // "TUM", "7-Scenes" or "numbered"
  std::vector<DepthFrameFile> frames;  // in the order of the list or of the numbers; stamps unchanged
  double depth_scale = 0.0;            // default of the layout: TUM 5000, others 1000
  std::optional<DepthCamera> camera;   // from a file camera.json, camera.txt or camera-intrinsics.txt, or the layout's
  std::string camera_problem;          // why there is no camera although there is such a file
  std::optional<Trajectory> truth;     // world_from_camera
  std::string truth_problem;           // why there is no truth although there is a groundtruth.txt
};

// The content of a folder with one of these layouts:
//   TUM        depth.txt with lines "stamp path", paths relative to the folder; optionally groundtruth.txt
//   7-Scenes   frame-000000.depth.png ...; optionally the poses frame-000000.pose.txt
//   numbered   1.png, 2.png ... or any names that end in a number, in the folder or in its folder depth/;
//              optionally groundtruth.txt.
//              A number with a decimal point (1305031453.374112.png) is a stamp in seconds
// Frames without stamps get their number / frames_per_s. Images are not opened. Throws IoError if the folder has none
// of these layouts or its list of images is damaged, and std::invalid_argument unless frames_per_s is above 0.
DepthSequence read_depth_sequence(const std::filesystem::path& folder, double frames_per_s = kUsualFramesPerS);

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
