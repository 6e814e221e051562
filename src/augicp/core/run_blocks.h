// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace augicp {

// Calls run_block(0), ..., run_block(num_blocks - 1), each once, in any order, concurrently on at most num_threads
// threads (0: all the machine's). An exception of run_block reaches the caller.
//
// run_blocks_tbb.cpp is the one that users get. The thread sanitizer sees no synchronisation inside the distribution's
// TBB, which is built without it, and reports races between any two blocks and their caller; builds with that sanitizer
// take run_blocks_threads.cpp, so that the races it reports are ours.
void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block);

}  // namespace augicp
