// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "augicp/core/words.h"
#include "augicp/registration/stage.h"

namespace augicp::app {

// Milliseconds since it was made.
class Stopwatch {
 public:
  double elapsed_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

enum class Progress {
  Auto,  // for people, if stderr is a terminal
  None,
  Json,  // one JSON object a line on stderr, for programs
};
}  // namespace augicp::app

namespace augicp {
template <>
inline constexpr auto kWords<app::Progress> = std::to_array<Word<app::Progress>>({{app::Progress::Auto, "auto"},
                                                                                  {app::Progress::None, "none"},
                                                                                  {app::Progress::Json, "json"}});
}  // namespace augicp

namespace augicp::app {

// The option --progress.
void add_progress_option(CLI::App& command, Progress& progress);

// A bar on stderr with the share done, the rate and the remaining time, if it is a terminal; or lines
// {"done": 3, "total": 12, "unit": "frames", "elapsed_s": 0.2}.
class ProgressBar {
 public:
  ProgressBar(std::size_t total, std::string unit, Progress progress);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance();

 private:
  void draw() const;

  std::size_t total_;
  std::size_t done_ = 0;
  std::string unit_;
  Progress shown_;  // never Auto
  Stopwatch started_;
  double next_drawing_ms_ = 0.0;
};

// What a command is doing, for work of unknown length: the step and its seconds on stderr, drawn anew by a thread
// from the first half second on, if it is a terminal; or lines {"step": "surfaces", "elapsed_s": 0.2}, one at
// the start of each step, with "done" and "total" for a step of several equal ones.
class StepLine {
 public:
  explicit StepLine(Progress progress);
  ~StepLine();
  StepLine(const StepLine&) = delete;
  StepLine& operator=(const StepLine&) = delete;

  // word: for programs; text: for people.
  void show(std::string_view word, std::string text, Turn turn = {});

  // Before something else is printed: the line vanishes until the next step.
  void hide();

 private:
  void draw_until_stopped(const std::stop_token& stop);

  Progress shown_;  // never Auto
  Stopwatch started_;
  std::mutex mutex_;
  std::string text_;
  Stopwatch step_started_;
  std::jthread drawing_;
};

}  // namespace augicp::app
