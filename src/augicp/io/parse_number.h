// SPDX-License-Identifier: MIT
// Numbers in text, the same in every locale: a point is the decimal mark.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace augicp {

// The number that all of text is, or nothing. A leading + and the spellings nan and inf are allowed. What is too large
// for a double is infinite, what is too small is zero.
std::optional<double> parse_double(std::string_view text);

// The count that all of text is: digits only, below 2^64. Nothing otherwise.
std::optional<std::uint64_t> parse_count(std::string_view text);

}  // namespace augicp
