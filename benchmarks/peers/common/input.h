// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "benchmarks/peers/common/job.h"
#include "benchmarks/peers/common/method.h"

namespace augicp::peers {

// Reads the two files of a job, and none twice in a row: in a sequence each image belongs to two jobs.
class InputReader {
 public:
  using Shared = std::shared_ptr<const Input>;

  // Source and target. Throws IoError, also for a cloud so far from zero that peers would lose digits.
  std::pair<Shared, Shared> read(const Job& job);

 private:
  struct Kept {
    std::filesystem::path path;
    Shared input;
  };
  Shared read_or_keep(const std::filesystem::path& path, const Job& job) const;

  Kept source_;
  Kept target_;
};

}  // namespace augicp::peers
