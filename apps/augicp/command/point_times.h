// SPDX-License-Identifier: MIT
// When the points of a LiDAR's sweep were measured: what --point-times means for a sequence.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/shutter/sweep.h"

namespace augicp::app {

struct PointTimes {
  enum class Source { None, Field, Order, Azimuth };

  Source source = Source::None;
  std::string field;     // of Source::Field
  double sweep_s = 0.0;  // how long a sweep takes; 0: unknown
  std::string in_words;
};

// given: auto, azimuth, none or the name of a field. auto takes the first known field of the first chosen scan that can
// be read, if its times differ, and else the order of the points. Throws IoError if a field is named that this scan
// does not have, or if the times of that field span no sweep.
PointTimes point_times_of(const ScanSequence& sequence, std::span<const std::size_t> chosen, const std::string& given);

// How a scan is read, so that it has the times that shares_of() needs.
ReadOptions read_options_for(const PointTimes& times);

// Throws IoError for times that are not finite.
SweepShares shares_of(const CloudFile& scan, const std::filesystem::path& path, const PointTimes& times);

}  // namespace augicp::app
