// SPDX-License-Identifier: MIT
#include "augicp/global/ball_lists.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/parallel.h"

namespace augicp {
namespace {

constexpr std::size_t kBallsPerBlock = 256;
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

// Points in the order of their cubes, with their indices.
struct Sorted {
  std::vector<float> x, y, z;
  std::vector<std::uint32_t> index;
};

// The support in cubes as wide as the radius, so that a ball lies within nine columns of three cubes.
class Cubes {
 public:
  Cubes(const std::vector<Vec3f>& support, double radius)
      : corner_(support.empty() ? Vec3f(Vec3f::Zero()) : support.front()), radius_(radius) {
    std::vector<Keyed> keyed;
    for (std::uint32_t i = 0; i < support.size(); ++i) keyed.push_back({key_of(cell_of(support[i])), i});
    std::sort(keyed.begin(), keyed.end());
    for (const auto& [key, i] : keyed) {
      keys_.push_back(key);
      sorted_.x.push_back(support[i].x()), sorted_.y.push_back(support[i].y()), sorted_.z.push_back(support[i].z());
      sorted_.index.push_back(i);
    }
  }

  void append_within(const Vec3f& query, std::vector<std::uint32_t>& found) const {
    const Cell middle = cell_of(query);
    for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x)
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
        const auto begin = std::lower_bound(keys_.begin(), keys_.end(), key_of({x, y, middle.z - 1}));
        const auto end = std::find_if(begin, keys_.end(),
                                      [last = key_of({x, y, middle.z + 1})](std::uint64_t key) { return key > last; });
        append_of(static_cast<std::size_t>(begin - keys_.begin()), static_cast<std::size_t>(end - keys_.begin()), query,
                  found);
      }
  }

 private:
  Cell cell_of(const Vec3f& point) const {
    const Vec3d place = (point - corner_).cast<double>() / radius_;
    const auto whole = [](double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate)); };
    return {whole(place.x()), whole(place.y()), whole(place.z())};
  }

  // Of the points in [begin, end). Each index is written, and kept if the next one does not replace it: a third of them
  // are within, and a branch would often be predicted wrongly.
  void append_of(std::size_t begin, std::size_t end, const Vec3f& query, std::vector<std::uint32_t>& found) const {
    const auto radius_sq = static_cast<float>(radius_ * radius_);
    std::size_t size = found.size();
    found.resize(size + end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      const float x = sorted_.x[k] - query.x(), y = sorted_.y[k] - query.y(), z = sorted_.z[k] - query.z();
      found[size] = sorted_.index[k];
      size += x * x + (y * y + z * z) <= radius_sq ? 1 : 0;
    }
    found.resize(size);
  }

  Vec3f corner_;
  double radius_;
  std::vector<std::uint64_t> keys_;
  Sorted sorted_;
};

}  // namespace

BallLists::BallLists(const std::vector<Vec3f>& queries, const std::vector<Vec3f>& support, double radius,
                     int num_threads)
    : begin_(queries.size() + 1) {
  const Cubes cubes(support, radius);
  std::vector<std::vector<std::uint32_t>> found((queries.size() + kBallsPerBlock - 1) / kBallsPerBlock);
  const auto search = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& of_block = found[begin / kBallsPerBlock];
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t before = of_block.size();
      cubes.append_within(queries[i], of_block);
      begin_[i + 1] = of_block.size() - before;
    }
  };
  for_each_block(queries.size(), num_threads, search, kBallsPerBlock);
  for (std::size_t i = 0; i < queries.size(); ++i) begin_[i + 1] += begin_[i];
  indices_.reserve(begin_.back());
  for (const auto& of_block : found) indices_.insert(indices_.end(), of_block.begin(), of_block.end());
}

}  // namespace augicp
