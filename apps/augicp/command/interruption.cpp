// SPDX-License-Identifier: MIT
#include "apps/augicp/command/interruption.h"

#include <unistd.h>

#include <csignal>
#include <ctime>
#include <mutex>
#include <string_view>
#include <thread>

namespace augicp::app {
namespace {

// Locked while a file is written. Global, because signals belong to the process.
std::recursive_mutex writing;

// What the next signal asks for a stop; null: it ends the process. And the one that has done so.
std::mutex stopping;
std::stop_source* to_stop = nullptr;
int stopped_by = 0;

// Whether a signal was for a StopOnSignal.
bool is_taken(int signal) {
  const std::lock_guard lock(stopping);
  if (!to_stop || stopped_by != 0) return false;
  stopped_by = signal;
  to_stop->request_stop();
  return true;
}

// A pipe without a reader must not block the command for ever.
constexpr int kMaxWaits = 100;
constexpr timespec kWait{0, 10'000'000};  // 10 ms

bool is_ignored(int signal) {
  struct sigaction present {};
  return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

sigset_t ending_signals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(signal)) ::sigaddset(&signals, signal);
  return signals;
}

void say_interrupted() {
  constexpr std::string_view kClearLine = "\r\033[K", kWords = "augicp: interrupted\n";
  // Bypasses stdio, whose lock the interrupted thread may hold. A failure cannot be reported.
  if (::isatty(STDERR_FILENO) == 1 && ::write(STDERR_FILENO, kClearLine.data(), kClearLine.size()) < 0) return;
  if (::write(STDERR_FILENO, kWords.data(), kWords.size()) < 0) return;
}

// Nothing is unwound: files are whole or absent whenever the mutex is free. So no loop has to check for a stop, but
// those whose results are kept.
void end_on_first_of(const sigset_t& signals) {
  int signal = 0;
  do {
    if (::sigwait(&signals, &signal) != 0) return;
  } while (is_taken(signal));
  for (int i = 0; i < kMaxWaits && !writing.try_lock(); ++i)
    if (::sigtimedwait(&signals, nullptr, &kWait) > 0) break;
  say_interrupted();
  ::_exit(128 + signal);
}

}  // namespace

void end_on_signals() {
  const sigset_t signals = ending_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(end_on_first_of, signals).detach();
}

StopOnSignal::StopOnSignal() {
  const std::lock_guard lock(stopping);
  to_stop = &source_;
  stopped_by = 0;
}

StopOnSignal::~StopOnSignal() {
  const std::lock_guard lock(stopping);
  to_stop = nullptr;
}

int StopOnSignal::exit_code() const {
  const std::lock_guard lock(stopping);
  return stopped_by == 0 ? 0 : 128 + stopped_by;
}

void write_whole(const std::function<void()>& write) {
  const std::lock_guard lock(writing);
  write();
}

}  // namespace augicp::app
