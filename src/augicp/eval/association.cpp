// SPDX-License-Identifier: MIT
#include "augicp/eval/association.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "augicp/core/check.h"

namespace augicp {
namespace {

// The stamps of both trajectories in one order. The closest two of different trajectories are always neighbours in it,
// also after others were removed. So only neighbours are compared.
struct Entry {
  double stamp_s = 0.0;
  std::size_t index = 0;
  bool of_estimate = false;
  std::size_t before = 0, after = 0;  // neighbours that are still present; the first and last entry are sentinels
  bool taken = false;
};

std::vector<Entry> merged(const Trajectory& estimate, const Trajectory& truth, double time_offset_s) {
  std::vector<Entry> entries(1);
  for (std::size_t i = 0; i < estimate.size(); ++i)
    entries.push_back({.stamp_s = estimate[i].stamp_s + time_offset_s, .index = i, .of_estimate = true});
  for (std::size_t i = 0; i < truth.size(); ++i) entries.push_back({.stamp_s = truth[i].stamp_s, .index = i});
  const auto by_stamp = [](const Entry& a, const Entry& b) { return a.stamp_s < b.stamp_s; };
  std::inplace_merge(entries.begin() + 1, entries.begin() + 1 + static_cast<std::ptrdiff_t>(estimate.size()),
                     entries.end(), by_stamp);
  entries.emplace_back();
  for (std::size_t i = 1; i + 1 < entries.size(); ++i) {
    entries[i].before = i - 1;
    entries[i].after = i + 1;
  }
  return entries;
}

// Two neighbours of different trajectories, the closest first.
struct Candidate {
  double difference_s = 0.0;
  std::size_t left = 0, right = 0;

  bool operator>(const Candidate& other) const {
    return std::tie(difference_s, left) > std::tie(other.difference_s, other.left);
  }
};

class ClosestFirst {
 public:
  ClosestFirst(std::vector<Entry> entries, double max_difference_s)
      : entries_(std::move(entries)), max_difference_s_(max_difference_s) {
    for (std::size_t i = 1; i + 2 < entries_.size(); ++i) consider(i, i + 1);
  }

  std::vector<StampPair> pairs() && {
    std::vector<StampPair> pairs;
    while (!candidates_.empty()) {
      const auto [difference_s, left, right] = candidates_.top();
      candidates_.pop();
      if (entries_[left].taken || entries_[right].taken) continue;
      const auto [estimate, truth] = entries_[left].of_estimate ? std::pair(left, right) : std::pair(right, left);
      pairs.push_back({entries_[estimate].index, entries_[truth].index});
      take_out(left, right);
    }
    std::sort(pairs.begin(), pairs.end(),
              [](const StampPair& a, const StampPair& b) { return a.estimate < b.estimate; });
    return pairs;
  }

 private:
  void consider(std::size_t left, std::size_t right) {
    const double difference_s = entries_[right].stamp_s - entries_[left].stamp_s;
    if (entries_[left].of_estimate != entries_[right].of_estimate && difference_s <= max_difference_s_)
      candidates_.push({difference_s, left, right});
  }

  void take_out(std::size_t left, std::size_t right) {
    entries_[left].taken = entries_[right].taken = true;
    const std::size_t before = entries_[left].before, after = entries_[right].after;
    entries_[before].after = after;
    entries_[after].before = before;
    if (before > 0 && after + 1 < entries_.size()) consider(before, after);
  }

  std::vector<Entry> entries_;
  double max_difference_s_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates_;
};

}  // namespace

void AssociationOptions::check() const {
  require_not_negative("max_difference_s", max_difference_s);
  require(std::isfinite(time_offset_s), "time_offset_s", time_offset_s, "must be finite");
}

std::vector<StampPair> associate(const Trajectory& estimate, const Trajectory& truth,
                                 const AssociationOptions& options) {
  options.check();
  return ClosestFirst(merged(estimate, truth, options.time_offset_s), options.max_difference_s).pairs();
}

}  // namespace augicp
