// SPDX-License-Identifier: MIT
#include "augicp/odometry/frame_report.h"

#include <cmath>
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

FrameReport frame_out_of_order(double stamp_s, int segment, const std::optional<double>& last_stamp_s) {
  FrameReport report;
  report.stamp_s = stamp_s;
  report.segment = segment;
  report.status = FrameStatus::OutOfOrder;
  report.problem = "its stamp is not finite";
  if (std::isfinite(stamp_s) && last_stamp_s)
    report.problem = "its stamp, " + std::to_string(stamp_s) + " s, is not after " + std::to_string(*last_stamp_s) +
                     " s, that of a frame before it";
  return report;
}

}  // namespace augicp
