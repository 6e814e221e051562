// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace augicp {

// All numbers of a small text, separated by blanks, commas or line ends, with or without brackets around rows; '#'
// starts a comment. Throws std::invalid_argument "what: line 2: expected a number, found 'x'", and if there are more
// than max_count.
std::vector<double> parse_number_list(std::string_view what, std::string_view text, std::size_t max_count);

// True if the first character that is not blank opens a JSON object.
bool starts_like_json(std::string_view text);

}  // namespace augicp
