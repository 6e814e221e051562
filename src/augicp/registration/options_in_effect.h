// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/options.h"

namespace augicp {

// The options as they took effect on two inputs: with the lengths that were used, and without the steps that the
// preset, the inputs or other options leave out. lengths: those of the result. are_clouds: false if an input is a depth
// image.
RegistrationOptions options_in_effect(RegistrationOptions options, const Lengths& lengths, bool are_clouds);

}  // namespace augicp
