// SPDX-License-Identifier: MIT
#include "augicp/global/ball_lists.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/parallel.h"

namespace augicp {
namespace {

constexpr std::size_t kQueriesPerBlock = 256;
constexpr int kBitsPerAxis = 21;
constexpr std::int64_t kMiddleCell = std::int64_t{1} << (kBitsPerAxis - 1);

struct Cell {
  std::int64_t x, y, z;
};

// Cells of one column, the same x and y, are neighbours in the order of their keys.
std::uint64_t key_of(const Cell& cell) {
  const auto part = [](std::int64_t place) {
    return static_cast<std::uint64_t>(std::clamp<std::int64_t>(place + kMiddleCell, 0, 2 * kMiddleCell - 1));
  };
  return part(cell.x) << (2 * kBitsPerAxis) | part(cell.y) << kBitsPerAxis | part(cell.z);
}

struct Keyed {
  std::uint64_t key;
  std::uint32_t index;
  bool operator<(const Keyed& other) const { return key != other.key ? key < other.key : index < other.index; }
};

// The support in cubes as wide as the radius, so that a ball lies within nine columns of three cubes.
class Cubes {
 public:
  Cubes(const std::vector<Vec3f>& support, double radius)
      : support_(support), corner_(support.empty() ? Vec3f(Vec3f::Zero()) : support.front()), radius_(radius) {
    for (std::uint32_t i = 0; i < support.size(); ++i) keyed_.push_back({key_of(cell_of(support[i])), i});
    std::sort(keyed_.begin(), keyed_.end());
  }

  void append_within(const Vec3f& query, std::vector<std::uint32_t>& found) const {
    const Cell middle = cell_of(query);
    const auto radius_sq = static_cast<float>(radius_ * radius_);
    for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x)
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
        const std::uint64_t last = key_of({x, y, middle.z + 1});
        auto at = std::lower_bound(keyed_.begin(), keyed_.end(), Keyed{key_of({x, y, middle.z - 1}), 0});
        for (; at != keyed_.end() && at->key <= last; ++at)
          if ((support_[at->index] - query).squaredNorm() <= radius_sq) found.push_back(at->index);
      }
  }

 private:
  Cell cell_of(const Vec3f& point) const {
    const Vec3d place = (point - corner_).cast<double>() / radius_;
    const auto whole = [](double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate)); };
    return {whole(place.x()), whole(place.y()), whole(place.z())};
  }

  const std::vector<Vec3f>& support_;
  Vec3f corner_;
  double radius_;
  std::vector<Keyed> keyed_;
};

}  // namespace

BallLists::BallLists(const std::vector<Vec3f>& queries, const std::vector<Vec3f>& support, double radius,
                     int num_threads)
    : begin_(queries.size() + 1) {
  const Cubes cubes(support, radius);
  std::vector<std::vector<std::uint32_t>> found((queries.size() + kQueriesPerBlock - 1) / kQueriesPerBlock);
  const auto search = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& of_block = found[begin / kQueriesPerBlock];
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t before = of_block.size();
      cubes.append_within(queries[i], of_block);
      begin_[i + 1] = of_block.size() - before;
    }
  };
  for_each_block(queries.size(), num_threads, search, kQueriesPerBlock);
  for (std::size_t i = 0; i < queries.size(); ++i) begin_[i + 1] += begin_[i];
  indices_.reserve(begin_.back());
  for (const auto& of_block : found) indices_.insert(indices_.end(), of_block.begin(), of_block.end());
}

}  // namespace augicp
