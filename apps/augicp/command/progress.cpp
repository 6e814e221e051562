// SPDX-License-Identifier: MIT
#include "apps/augicp/command/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdio>
#include <utility>

#include "apps/augicp/command/choice.h"

namespace augicp::app {
namespace {

constexpr std::size_t kWidth = 30;             // characters of the bar
constexpr double kBetweenDrawings_ms = 100.0;  // fast enough to read, too slow to cost anything
constexpr const char* kClearLine = "\r\033[K";

// Shorter work needs no line, which would only flicker.
constexpr double kFirstDrawing_ms = 500.0;

// What Auto means here: Auto on a terminal, else None.
Progress shown(Progress progress) {
  return progress == Progress::Auto && ::isatty(STDERR_FILENO) != 1 ? Progress::None : progress;
}

std::string json_of(Turn turn) {
  return turn.total > 1 ? fmt::format(", \"done\": {}, \"total\": {}", turn.done, turn.total) : "";
}

}  // namespace

void add_progress_option(CLI::App& command, Progress& progress) {
  command
      .add_option("--progress", progress,
                  "auto: a line on stderr if that is a terminal; json: a line of JSON a step, for programs")
      ->default_str("auto")
      ->transform(choice<Progress>())
      ->group("Output");
}

ProgressBar::ProgressBar(std::size_t total, std::string unit, Progress progress)
    : total_(total), unit_(std::move(unit)), shown_(shown(progress)) {}

ProgressBar::~ProgressBar() {
  if (shown_ == Progress::Auto) fmt::print(stderr, "{}", kClearLine);
}

void ProgressBar::advance() {
  ++done_;
  if (shown_ == Progress::Json)
    fmt::print(stderr, "{{\"done\": {}, \"total\": {}, \"unit\": \"{}\", \"elapsed_s\": {:.3f}}}\n", done_, total_,
               unit_, started_.elapsed_ms() / 1000.0);
  if (shown_ != Progress::Auto || (started_.elapsed_ms() < next_drawing_ms_ && done_ < total_)) return;
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

StepLine::StepLine(Progress progress) : shown_(shown(progress)) {
  if (shown_ == Progress::Auto)
    drawing_ = std::jthread([this](const std::stop_token& stop) { draw_until_stopped(stop); });
}

StepLine::~StepLine() {
  if (!drawing_.joinable()) return;
  drawing_.request_stop();
  drawing_.join();
  fmt::print(stderr, "{}", kClearLine);
}

void StepLine::show(std::string_view word, std::string text, Turn turn) {
  if (shown_ == Progress::Json)
    fmt::print(stderr, "{{\"step\": \"{}\"{}, \"elapsed_s\": {:.3f}}}\n", word, json_of(turn),
               started_.elapsed_ms() / 1000.0);
  const std::lock_guard lock(mutex_);
  text_ = std::move(text);
  step_started_ = {};
}

void StepLine::hide() {
  const std::lock_guard lock(mutex_);
  text_.clear();
  if (drawing_.joinable()) fmt::print(stderr, "{}", kClearLine);
}

void StepLine::draw_until_stopped(const std::stop_token& stop) {
  std::mutex waiting;
  std::condition_variable_any changed;
  std::unique_lock wait_lock(waiting);
  while (!changed.wait_for(wait_lock, stop, std::chrono::duration<double, std::milli>(kBetweenDrawings_ms), [] {
    return false;
  }) && !stop.stop_requested()) {
    const std::lock_guard lock(mutex_);
    if (text_.empty() || started_.elapsed_ms() < kFirstDrawing_ms) continue;
    fmt::print(stderr, "{}{}  {:.0f} s", kClearLine, text_, step_started_.elapsed_ms() / 1000.0);
    std::fflush(stderr);
  }
}

}  // namespace augicp::app
