// SPDX-License-Identifier: MIT
#include "augicp/core/parallel.h"

#include <algorithm>

#include "augicp/core/check.h"
#include "augicp/core/run_blocks.h"

namespace augicp {

void for_each_block(std::size_t count, int num_threads, const std::function<void(std::size_t, std::size_t)>& body,
                    std::size_t block_size) {
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
  const std::size_t num_blocks = (count + block_size - 1) / block_size;
  const auto run_block = [&](std::size_t block) {
    body(block * block_size, std::min(count, (block + 1) * block_size));
  };
  if (num_threads == 1 || num_blocks <= 1) {
    for (std::size_t block = 0; block < num_blocks; ++block) run_block(block);
    return;
  }
  run_blocks(num_blocks, num_threads, run_block);
}

}  // namespace augicp
