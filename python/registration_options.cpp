// SPDX-License-Identifier: MIT
#include "python/registration_options.h"

#include "augicp/registration/words.h"

namespace augicp::python {

const OptionTable<RegistrationOptions>& registration_options() {
  using Options = RegistrationOptions;
  static const OptionTable<Options> table{
      {"preset", word<Options>(kPresets, &Options::preset)},
      {"method", word<Options>(kMethods, &Options::method)},
      {"association", word<Options>(kAssociations, &Options::association)},
      {"radius", number<Options>(&Options::radius)},
      {"voxel_size", number<Options>(&Options::voxel_size)},
      {"max_distance", number<Options>(&Options::max_distance)},
      {"max_angle", number<Options>(&Options::max_angle)},
      {"classifier", word_or_none<Options>(kClassifiers, &Options::classifier)},
      {"kernel_chi2", number<Options>(&Options::kernel_chi2)},
      {"lever", number<Options>(&Options::lever)},
      {"damping", number<Options>(&Options::damping)},
      {"search", number<Options>(&Options::search)},
      {"coarse_to_fine", number<Options>(&Options::coarse_to_fine)},
      {"rolling_shutter", number<Options>(&Options::rolling_shutter)},
      {"intensity", number<Options>(&Options::intensity)},
      {"covariance", number<Options>(&Options::covariance)},
      {"max_iterations", number<Options>(&Options::max_iterations)},
      {"min_step", number<Options>(&Options::min_step)},
      {"threads", number<Options>(&Options::num_threads)},
  };
  return table;
}

}  // namespace augicp::python
