// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "augicp/core/run_blocks.h"

namespace augicp {

void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block) {
  // An arena of our own: the caller's thread limit holds for this loop only, and nothing global changes.
  tbb::task_arena arena(num_threads == 0 ? tbb::task_arena::automatic : num_threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, num_blocks, run_block, tbb::simple_partitioner{}); });
}

}  // namespace augicp
