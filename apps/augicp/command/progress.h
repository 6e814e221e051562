// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "augicp/core/words.h"

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

enum class Progress { Auto, None };
}  // namespace augicp::app

namespace augicp {
template <>
inline constexpr auto kWords<app::Progress> = std::to_array<Word<app::Progress>>({{app::Progress::Auto, "auto"},
                                                                                  {app::Progress::None, "none"}});
}  // namespace augicp

namespace augicp::app {

// A bar on stderr with the share done, the rate and the remaining time. Nothing if stderr is not a terminal or Progress
// is None.
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
  bool is_shown_;
  Stopwatch started_;
  double next_drawing_ms_ = 0.0;
};

}  // namespace augicp::app
