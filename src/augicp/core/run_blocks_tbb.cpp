// SPDX-License-Identifier: MIT
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

#include "augicp/core/run_blocks.h"

namespace augicp {

void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block) {
  const auto run_all = [&] { tbb::parallel_for(std::size_t{0}, num_blocks, run_block, tbb::simple_partitioner{}); };
  const std::size_t limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  if (num_threads == 0 || static_cast<std::size_t>(num_threads) >= limit) return run_all();
  // A separate arena: the caller's thread limit applies to this loop only, and nothing global changes. It costs about
  // 50 microseconds.
  tbb::task_arena arena(num_threads);
  arena.execute(run_all);
}

}  // namespace augicp
