// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/odometry/odometry.h"
#include "augicp/registration/option_table.h"

namespace augicp {

// Every option of odometry, then those of its registrations, see core/option.h.
template <OptionsOf<OdometryOptions> Options, typename Visit>
void for_each_option(Options& options, const Visit& visit) {
  using namespace option_group;
  using enum Unit;
  visit({"reference", None, kMethod, "What a frame is registered to: a model of the last frames, or the previous one"},
        options.reference);
  visit({"pixel_step", None, kMethod, "Use every N-th pixel and row; 0 picks N so that at least 160 columns remain"},
        options.pixel_step);
  visit({"min_depth", Metres, kMethod, "Nearer readings are not used"}, options.range.min);
  visit({"max_depth", Metres, kMethod, "Farther readings are not used", "none"}, options.range.max);
  visit({"min_overlap", None, kMethod, "A frame is lost if a smaller share of it finds a partner"},
        options.min_overlap);
  visit({"keyframe_overlap", None, kMethod, "A frame becomes the keyframe if a smaller share of it finds a partner"},
        options.keyframe_overlap);
  visit({"max_strain", None, kMethod, "A frame is doubtful above this strain"}, options.max_strain);
  visit({"max_lost", None, kMethod, "A new segment starts after this number of lost or doubtful frames in a row"},
        options.max_lost);
  visit({"max_extrapolation_s", Seconds, kMethod, "The motion is extrapolated for no longer than this"},
        options.max_extrapolation_s);
  for_each_option(options.registration, visit);
}

}  // namespace augicp
