// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace augicp {

// Calls run_block(0), ..., run_block(num_blocks - 1), each once, in any order, concurrently on at most num_threads
// threads (0: all of the machine). An exception of run_block reaches the caller.
//
// Two implementations exist. run_blocks_tbb.cpp is the one that users get. run_blocks_threads.cpp is for the thread
// sanitizer: the distribution's TBB is built without it, so the sanitizer cannot see TBB's synchronisation and reports
// false races.
void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block);

}  // namespace augicp
