// SPDX-License-Identifier: MIT
#include "augicp/odometry/frame_report.h"

#include <utility>

namespace augicp {

bool has_pose(FrameStatus status) {
  return status == FrameStatus::Started || status == FrameStatus::Tracked || status == FrameStatus::Degenerate ||
         status == FrameStatus::Doubtful;
}

FrameReport unreadable_frame(double stamp_s, int segment, std::string problem) {
  FrameReport report;
  report.stamp_s = stamp_s;
  report.segment = segment;
  report.status = FrameStatus::Unreadable;
  report.problem = std::move(problem);
  return report;
}

}  // namespace augicp
