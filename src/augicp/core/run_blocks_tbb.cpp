// SPDX-License-Identifier: MIT
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "augicp/core/run_blocks.h"

namespace augicp {

void run_blocks(std::size_t num_blocks, int num_threads, const std::function<void(std::size_t)>& run_block) {
  const auto run_all = [&] { tbb::parallel_for(std::size_t{0}, num_blocks, run_block, tbb::simple_partitioner{}); };
  if (num_threads == 0) return run_all();
  // More threads than TBB has would gain nothing, and make it print a warning.
  const auto limit = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int concurrency = static_cast<int>(std::min(limit, static_cast<std::size_t>(num_threads)));
  // An arena of our own: the caller's thread limit holds for this loop only, and nothing global changes.
  tbb::task_arena arena(concurrency);
  arena.execute(run_all);
}

}  // namespace augicp
