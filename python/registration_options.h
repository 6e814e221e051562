// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/options.h"
#include "python/options.h"

namespace augicp::python {

// Every option of a registration by its keyword.
const OptionTable<RegistrationOptions>& registration_options();

}  // namespace augicp::python
