// SPDX-License-Identifier: MIT
#include "apps/augicp/page/status_strip.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace augicp::app {
namespace {

constexpr double kWidth = 1000.0, kHeight = 26.0, kKeyframeHeight = 7.0;

std::string bar(const std::string& style, double x, double y, double width) {
  return fmt::format("<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\"/>\n", style, x, y,
                     width, kHeight - y);
}

std::string bars(const OdometryRun& run) {
  const double per_frame = kWidth / static_cast<double>(run.rows.size());
  const auto at = [&](std::size_t i) { return status_class(run.rows[i].report.status); };
  std::string content;
  for (std::size_t begin = 0, end = 0; begin < run.rows.size(); begin = end) {
    for (end = begin + 1; end < run.rows.size() && at(end) == at(begin);) ++end;
    content +=
        bar(at(begin), per_frame * static_cast<double>(begin), 0.0, per_frame * static_cast<double>(end - begin));
  }
  for (std::size_t i = 0; i < run.rows.size(); ++i)
    if (run.rows[i].report.is_keyframe)
      content +=
          bar("keyframe", per_frame * static_cast<double>(i), kHeight - kKeyframeHeight, std::min(per_frame, 4.0));
  return content;
}

std::string key(const std::string& style, const std::string& text) {
  return fmt::format("<span><i class=\"key {}\"></i>{}</span>", style, text);
}

std::string key_html(const OdometryRun& run) {
  std::map<FrameStatus, int> counts;
  int num_keyframes = 0;
  for (const FrameRow& row : run.rows) {
    ++counts[row.report.status];
    if (row.report.is_keyframe) ++num_keyframes;
  }
  std::string html = "<p class=\"legend\">";
  for (const auto& [status, count] : counts)
    html += key(status_class(status), fmt::format("{} {}", count, name_of(status)));
  return html + key("keyframe", fmt::format("{} keyframes", num_keyframes)) + "</p>\n";
}

}  // namespace

std::string status_class(FrameStatus status) {
  const bool is_other =
      status == FrameStatus::NoReadings || status == FrameStatus::OutOfOrder || status == FrameStatus::Unreadable;
  return is_other ? "other" : std::string(name_of(status));
}

std::string strip_html(const OdometryRun& run) {
  return key_html(run) + fmt::format(
                             "<svg class=\"strip\" viewBox=\"0 0 {:g} {:g}\" preserveAspectRatio=\"none\" role=\"img\" "
                             "aria-label=\"Status of each frame\">\n{}</svg>\n",
                             kWidth, kHeight, bars(run));
}

}  // namespace augicp::app
