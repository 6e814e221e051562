// SPDX-License-Identifier: MIT
// A LAS file as it is, so that its points can be moved and the rest written again byte for byte. Source: ASPRS, LAS
// Specification 1.4 - R15.
#pragma once

#include <cstddef>
#include <string>

#include "augicp/core/types.h"
#include "augicp/io/point_fields.h"

namespace augicp {

struct LasRecords {
  std::string head;     // header and variable length records: all bytes before the points
  std::string records;  // record_length bytes a point
  std::string tail;     // all bytes behind the points
  std::size_t record_length = 0;
  int point_format = 0;         // 0 to 10
  Vec3d scale = Vec3d::Ones();  // metres a unit, of the three integers of a position
  Vec3d offset = Vec3d::Zero();

  std::size_t num_points() const { return records.size() / record_length; }
};

// The numbers of each point beside its position, by their usual names, bits as bytes, extra bytes as their description
// states. What no column has is in not_kept.
PointFields fields_of(const LasRecords& las);

}  // namespace augicp
