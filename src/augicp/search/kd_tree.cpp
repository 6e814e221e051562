// SPDX-License-Identifier: MIT
#include "augicp/search/kd_tree.h"

#include <limits>
#include <nanoflann.hpp>

namespace augicp {
namespace {

constexpr std::size_t kLeafSize = 16;

// What nanoflann asks of a data set.
struct PointAdaptor {
  const std::vector<Vec3f>& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<Eigen::Index>(axis)]; }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointAdaptor>, PointAdaptor, 3, std::uint32_t>;

// The first of the nearest. nanoflann enters every branch that may hold a point as near as the worst one kept, so that among
// many equal points each query would look at all of them: from here on a branch has to promise more than rounding can hide.
struct NearestResultSet {
  using DistanceType = float;
  using IndexType = std::uint32_t;
  static constexpr float kRounding = 1e-6f;
  Neighbour best;  // with the gate's distance until there is one
  bool is_found = false;

  std::size_t size() const { return is_found ? 1 : 0; }
  bool full() const { return true; }
  bool addPoint(float distance_sq, std::uint32_t index) {
    if (distance_sq < best.distance_sq) best = {index, distance_sq}, is_found = true;
    return true;
  }
  // Below zero once a point is found at distance zero: nothing is nearer.
  float worstDist() const {
    return is_found ? (1.0f - kRounding) * best.distance_sq - std::numeric_limits<float>::denorm_min() : best.distance_sq;
  }
};

}  // namespace

struct KdTree::Index {
  explicit Index(const Cloud& cloud)
      : adaptor{cloud.points}, tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize)) {
    if (!cloud.empty()) tree.buildIndex();
  }
  PointAdaptor adaptor;
  Tree tree;
};

KdTree::KdTree(const Cloud& cloud) : index_(std::make_unique<Index>(cloud)) {}
KdTree::~KdTree() = default;
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;

std::optional<Neighbour> KdTree::nearest(const Vec3f& query, float max_distance_sq) const {
  if (index_->adaptor.points.empty()) return std::nullopt;
  // The result set prunes by its worst distance: starting it at the gate skips all that lies beyond.
  NearestResultSet result{{0, max_distance_sq}};
  index_->tree.findNeighbors(result, query.data(), nanoflann::SearchParams());
  if (!result.is_found) return std::nullopt;
  return result.best;
}

std::vector<Neighbour> KdTree::nearest_k(const Vec3f& query, std::size_t count) const {
  if (index_->adaptor.points.empty() || count == 0) return {};
  std::vector<std::uint32_t> indices(count);
  std::vector<float> distances_sq(count);
  const std::size_t num_found = index_->tree.knnSearch(query.data(), count, indices.data(), distances_sq.data());
  std::vector<Neighbour> found(num_found);
  for (std::size_t k = 0; k < num_found; ++k) found[k] = {indices[k], distances_sq[k]};
  return found;
}

}  // namespace augicp
