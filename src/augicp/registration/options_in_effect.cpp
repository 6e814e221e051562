// SPDX-License-Identifier: MIT
#include "augicp/registration/options_in_effect.h"

namespace augicp {

RegistrationOptions options_in_effect(RegistrationOptions options, const Lengths& lengths, bool are_clouds) {
  if (options.preset == Preset::Paper)
    options.search = options.coarse_to_fine = options.rolling_shutter = options.final_pass = false;
  // Lengths that are given are not made smaller, and without a covariance no result is more certain.
  if (!are_clouds || options.radius || options.voxel_size || !options.covariance) options.final_pass = false;
  if (lengths.radius > 0.0) {
    options.radius = lengths.radius;
    options.voxel_size = lengths.voxel_size;
    options.max_distance = lengths.max_distance;
  }
  return options;
}

}  // namespace augicp
