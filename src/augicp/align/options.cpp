// SPDX-License-Identifier: MIT
#include "augicp/align/align.h"
#include "augicp/core/check.h"

namespace augicp {

void AlignOptions::check() const {
  information.check();
  gates.check();
  if (lever) require_not_negative("lever", *lever);
  require(max_lever >= 0.0, "max_lever", max_lever, "must be at least 0");
  if (kernel_chi2) require(*kernel_chi2 > 0.0, "kernel_chi2", *kernel_chi2, "must be above 0");
  require_not_negative("min_kernel_chi2", min_kernel_chi2);
  require(gate_per_median > 0.0, "gate_per_median", gate_per_median, "must be above 0");
  require_not_negative("min_max_distance", min_max_distance);
  require_positive("kernel_per_median", kernel_per_median);
  require(kernel_quantile > 0.0 && kernel_quantile <= 0.5, "kernel_quantile", kernel_quantile, "must be in (0, 0.5]");
  require(kernel_direction_per_median > 0.0, "kernel_direction_per_median", kernel_direction_per_median,
          "must be above 0");
  require_not_negative("intensity_weight", intensity_weight);
  require_positive("kernel_intensity_per_median", kernel_intensity_per_median);
  require_not_negative("damping", damping);
  require(max_iterations > 0, "max_iterations", max_iterations, "must be at least 1");
  require(max_stretch >= 1.0, "max_stretch", max_stretch, "must be at least 1");
  require_not_negative("min_translation_step", min_translation_step);
  require_not_negative("min_rotation_step", min_rotation_step);
  require_not_negative("min_observability", min_observability);
  if (free_directions)
    require(free_directions->num_free >= 0 && free_directions->num_free <= 6, "num_free", free_directions->num_free,
            "must be from 0 to 6");
  require_not_negative("correlation_length", correlation_length);
  require(num_threads >= 0, "num_threads", num_threads, "must be at least 0 (0: all)");
}

}  // namespace augicp
