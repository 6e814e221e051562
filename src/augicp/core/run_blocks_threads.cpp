// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "augicp/core/run_blocks.h"

namespace augicp {

void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block) {
  // Relaxed: blocks must not synchronise by accident, or the sanitizer would miss races between them.
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t block = next.fetch_add(1, std::memory_order_relaxed); block < num_blocks;
           block = next.fetch_add(1, std::memory_order_relaxed))
        run_block(block);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
    }
  };
  // At least two, also on a machine with one core: the sanitizer finds races without a second core.
  const std::size_t wanted = num_threads == 0 ? std::max(2u, std::thread::hardware_concurrency()) : num_threads;
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(wanted, num_blocks); ++i) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace augicp
