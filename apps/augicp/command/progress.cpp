// SPDX-License-Identifier: MIT
#include "apps/augicp/command/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace augicp::app {
namespace {

constexpr std::size_t kWidth = 30;             // characters of the bar
constexpr double kBetweenDrawings_ms = 100.0;  // fast enough to read, too slow to cost anything
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

ProgressBar::ProgressBar(std::size_t total, std::string unit, Progress progress)
    : total_(total), unit_(std::move(unit)), is_shown_(progress == Progress::Auto && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (is_shown_) fmt::print(stderr, "{}", kClearLine);
}

void ProgressBar::advance() {
  ++done_;
  if (!is_shown_ || (started_.elapsed_ms() < next_drawing_ms_ && done_ < total_)) return;
  next_drawing_ms_ = started_.elapsed_ms() + kBetweenDrawings_ms;
  draw();
}

void ProgressBar::draw() const {
  const double seconds = started_.elapsed_ms() / 1000.0;
  const double rate = seconds > 0.0 ? static_cast<double>(done_) / seconds : 0.0;
  const double left_s = rate > 0.0 ? static_cast<double>(total_ - done_) / rate : 0.0;
  const std::size_t filled = total_ > 0 ? kWidth * done_ / total_ : kWidth;
  fmt::print(stderr, "{}[{}{}] {}/{} {}  {:.1f}/s  {:.0f} s left", kClearLine, std::string(filled, '#'),
             std::string(kWidth - filled, '.'), done_, total_, unit_, rate, left_s);
  std::fflush(stderr);
}

}  // namespace augicp::app
