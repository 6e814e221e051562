// SPDX-License-Identifier: MIT
// Which topic of a recording --topic means.
#pragma once

#include <string>
#include <vector>

#include "augicp/io/bag_topics.h"

namespace augicp::app {

// The topic of that name, or if no name is given the only one of these types. Only depth images count as images. Throws
// IoError that lists the topics of these types, with the number of their messages.
StampedTopic chosen_topic(const std::string& bag, const std::string& name, const std::vector<std::string>& types);

}  // namespace augicp::app
