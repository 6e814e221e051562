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
  std::vector<DepthFrameFile> frames;  // in the order of the list or of the numbers; stamps as they are
  double depth_scale = 0.0;            // the layout's: TUM 5000, others 1000
  std::optional<DepthCamera> camera;   // of a file camera.json, camera.txt or camera-intrinsics.txt, or the layout's
  std::string camera_problem;          // why there is none, where there is such a file
  std::optional<Trajectory> truth;     // world_from_camera
  std::string truth_problem;           // why there is none, where there is a groundtruth.txt
};

// What is in a folder, which must be one of
//   TUM        depth.txt with lines "stamp path", paths relative to the folder; groundtruth.txt if there is one
//   7-Scenes   frame-000000.depth.png ...; the poses frame-000000.pose.txt of those frames that have one
//   numbered   1.png, 2.png ... or any names that end in a number, in the folder or in its folder depth/;
//   groundtruth.txt.
//              A number with a decimal point (1305031453.374112.png) is a stamp in seconds
// Frames without stamps get their number / frames_per_s. Images are not opened. Throws IoError where the folder is none
// of these or its list of images is damaged, std::invalid_argument unless frames_per_s is above 0.
DepthSequence read_depth_sequence(const std::filesystem::path& folder, double frames_per_s = kUsualFramesPerS);

// Reads the frames of a list one by one, as they are asked for. An image that cannot be read
// becomes a frame with a problem; a depth scale that is wrong by a factor is an IoError (see check_depth_scale), looked
// for in the first image with readings in more than a hundredth of its pixels.
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
