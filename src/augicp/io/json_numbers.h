// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace augicp {

// The numbers under a key of the JSON object in text: one number, an array of them, or an array of rows of them, in
// order. Nothing where the object lacks the key. Throws std::invalid_argument, whose message starts with what, where
// text is no JSON object or there is anything else under the key.
std::optional<std::vector<double>> json_numbers(std::string_view what, std::string_view text, const std::string& key);

}  // namespace augicp
