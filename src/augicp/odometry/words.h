// SPDX-License-Identifier: MIT
// Words of enumerators, for the command, its files and Python.
#pragma once

#include "augicp/core/words.h"
#include "augicp/odometry/odometry.h"

namespace augicp {

inline const std::map<std::string, Reference> kReferences{{"model", Reference::Model},
                                                          {"previous", Reference::PreviousFrame}};

}  // namespace augicp
