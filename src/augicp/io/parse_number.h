// SPDX-License-Identifier: MIT
// Numbers in text, the same in every locale: the decimal mark is a point.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace augicp {

// The number if all of text is one, else empty. A leading + and the spellings nan and inf are allowed. A number too
// large for a double is infinite, one too small is zero.
std::optional<double> parse_double(std::string_view text);

// The count if all of text is one: digits only, below 2^64. Otherwise empty.
std::optional<std::uint64_t> parse_count(std::string_view text);

}  // namespace augicp
