// SPDX-License-Identifier: MIT
// Stamps of frames that are expected in seconds and may be in another unit.
#pragma once

#include <string>
#include <vector>

namespace augicp {

// The largest number of a frame, a year of frames or more: a larger one is a stamp in some unit.
inline constexpr double kMaxFrameNumber = 1e9;

// Brings the stamps of frames that follow one another into seconds. They may have any order. Stamps that cannot be
// seconds, because they lie beyond kMaxStamp_s or frames would be hours apart, are divided by the one unit among
// milli-, micro- and nanoseconds that makes them frames of a sensor or dates of our time. Seconds that would suit
// milliseconds better stay. Returns a sentence on what was done or is suspected, empty for plausible seconds. REQUIRES:
// finite stamps. Throws std::invalid_argument if no unit suits, or several do; the stamps then are unchanged.
std::string bring_into_seconds(std::vector<double>& stamps);

}  // namespace augicp
