// SPDX-License-Identifier: MIT
// Parallel loops. Results are bit-identical for any number of threads.
//
// Work is cut into blocks of a fixed size. One thread does a block, and partial sums are added in block order.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace augicp {

// Items of one block. Large enough to hide the cost of a task, small enough to share a depth image evenly between two
// cores.
inline constexpr std::size_t kBlockSize = 2048;

// Block size for cheap loops (a few nanoseconds per item). A block must outlast a thread wake-up; otherwise, on a busy
// machine, all threads wait for the late one.
inline constexpr std::size_t kLightBlockSize = 16384;

// Calls body(begin, end) for every block of [0, count), concurrently on at most num_threads threads (0: all of the
// machine). REQUIRES: blocks write to disjoint places. An exception of body reaches the caller.
void for_each_block(std::size_t count, int num_threads, const std::function<void(std::size_t, std::size_t)>& body,
                    std::size_t block_size = kBlockSize);

// The sum over blocks of body(begin, end), added in block order. REQUIRES: Sum has a zero default value and operator+=.
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

// The threads of each of two tasks that run side by side.
inline int half_of_threads(int num_threads) { return num_threads > 1 ? num_threads / 2 : num_threads; }

// The results of two functions without arguments, called concurrently unless num_threads is 1. REQUIRES: neither writes
// what the other uses. An exception of either reaches the caller.
template <typename One, typename Other>
auto both(int num_threads, const One& one, const Other& other) {
  std::optional<std::invoke_result_t<One>> of_one;
  std::optional<std::invoke_result_t<Other>> of_other;
  const auto call = [&](std::size_t task, std::size_t) {
    if (task == 0)
      of_one.emplace(one());
    else
      of_other.emplace(other());
  };
  for_each_block(2, num_threads, call, 1);
  return std::pair(std::move(*of_one), std::move(*of_other));
}

}  // namespace augicp
