// SPDX-License-Identifier: MIT
#include "python/odometry_options.h"

#include "augicp/odometry/words.h"
#include "python/registration_options.h"

namespace augicp::python {
namespace {

OptionTable<OdometryOptions> made() {
  using Options = OdometryOptions;
  OptionTable<Options> table{
      {"reference", word<Options>(kReferences, &Options::reference)},
      {"pixel_step", number<Options>(&Options::pixel_step)},
      {"min_depth", number<Options>([](auto& options) -> auto& { return options.range.min; })},
      {"max_depth", number<Options>([](auto& options) -> auto& { return options.range.max; })},
      {"min_overlap", number<Options>(&Options::min_overlap)},
      {"keyframe_overlap", number<Options>(&Options::keyframe_overlap)},
      {"max_strain", number<Options>(&Options::max_strain)},
      {"max_lost", number<Options>(&Options::max_lost)},
      {"max_extrapolation_s", number<Options>(&Options::max_extrapolation_s)},
  };
  for (const auto& [name, option] : registration_options())
    table[name] = {[set = option.set](const std::string& key, const py::handle& value, Options& options) {
                     set(key, value, options.registration);
                   },
                   [value = option.value](const Options& options) { return value(options.registration); }};
  return table;
}

}  // namespace

const OptionTable<OdometryOptions>& odometry_options() {
  static const OptionTable<OdometryOptions> table = made();
  return table;
}

}  // namespace augicp::python
