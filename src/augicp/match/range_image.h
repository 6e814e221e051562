// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "augicp/cloud/cloud.h"

namespace augicp {

// What a sensor says of a place that it may have looked at.
enum class Sight {
  OutOfView,  // no line of sight of the sensor passes near
  Free,       // in front of the surface: the sensor saw through this place
  AtSurface,  // neither in front of all that was seen there nor behind it
  Hidden,     // behind the surface
};

// Lines of sight of a cloud without a camera: the nearest and the farthest range in each cell of a sphere around the
// sensor's place. The cells are the pixels of a cube's six faces, as fine as the cloud's points fill them. Each point
// also counts in the eight cells around its own, so that cells between sparse points are not out of view, and a cell on
// a depth step has both its ranges.
//
// The cloud must outlive it. Const calls may run concurrently.
class RangeImage {
 public:
  // place: of the sensor, metres, relative to the cloud's origin as its points are.
  RangeImage(const Cloud& cloud, const Vec3f& place);

  // A point relative to the cloud's origin. What is nearer to the surface than the tolerance (metres) is AtSurface. The
  // distance is that along the line of sight, and where the surface's normal is known also that from its plane:
  // a surface seen at a slant has many ranges in a cell.
  Sight sight(const Vec3f& point, float tolerance) const;

  // The share of the cloud's own points, in [0, 1], in front of which lie other points in their own cell and in all
  // cells around it that have any, nearer by more than the tolerance. From where the cloud was seen there are hardly
  // any.
  double share_behind(float tolerance) const;

  const Vec3f& place() const { return place_; }
  // Whether its cells tell the cloud's points apart. From very far they do not.
  bool is_fine_enough() const;

  int cells_per_edge() const { return cells_per_edge_; }

 private:
  struct Cell {
    float nearest_range, farthest_range;  // metres
    std::int32_t nearest_point;           // kNone: empty
  };
  static constexpr std::int32_t kNone = -1;

  std::vector<Cell> empty_cells() const;
  void add(std::vector<Cell>& cells, std::size_t cell, std::int32_t point, float range) const;
  bool is_off_plane(std::int32_t point, const Vec3f& place, float tolerance) const;
  bool is_behind_all_around(const Vec3f& point, float tolerance) const;

  const Cloud& cloud_;
  Vec3f place_;
  int cells_per_edge_ = 1;
  std::vector<Cell> own_, spread_;  // of the points in a cell; and of those in the cells around
};

// The lines of sight of a cloud from its sensor's assumed place, see ray_spacing.h; none if its cells do not tell the
// points apart, or for an empty cloud. If the place is not known, it must fit: hardly any point lies farther than the
// tolerance (metres) behind others, as seen from there.
std::optional<RangeImage> lines_of_sight(const Cloud& cloud, float tolerance, bool place_is_known = false);

}  // namespace augicp
