// SPDX-License-Identifier: MIT
// Parallel loops whose results do not depend on the number of threads.
//
// Work is cut into blocks of a fixed size; each block is done by one thread, and partial sums are added in block order.
// So the same input gives the same bits on one thread and on sixty-four.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace augicp {

// Items of one block. Large enough to hide the cost of a task, small enough for two cores to share a depth image
// evenly.
inline constexpr std::size_t kBlockSize = 2048;

// Of loops that take some nanoseconds an item: a block should take longer than to wake a thread, or on a busy machine
// all wait for it.
inline constexpr std::size_t kLightBlockSize = 16384;

// Calls body(begin, end) for every block of [0, count), concurrently on at most num_threads threads (0: all the
// machine's). Blocks must not write to shared places. An exception of body reaches the caller.
void for_each_block(std::size_t count, int num_threads, const std::function<void(std::size_t, std::size_t)>& body,
                    std::size_t block_size = kBlockSize);

// The sum over blocks of body(begin, end), added in block order. Sum needs a zero default value and operator+=.
template <typename Sum, typename Body>
Sum blocked_sum(std::size_t count, int num_threads, const Body& body, std::size_t block_size = kBlockSize) {
  std::vector<Sum> partial((count + block_size - 1) / block_size);
  for_each_block(
      count, num_threads, [&](std::size_t begin, std::size_t end) { partial[begin / block_size] = body(begin, end); },
      block_size);
  Sum total{};
  for (const Sum& sum : partial) total += sum;
  return total;
}

}  // namespace augicp
