// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace augicp {

// The numbers under a key of the JSON object in text: one number, an array of numbers, or an array of rows of numbers,
// in order. Empty if the object lacks the key. Throws std::invalid_argument, with a message that starts with `what`, if
// text is no JSON object or the key has any other value.
std::optional<std::vector<double>> json_numbers(std::string_view what, std::string_view text, const std::string& key);

// The text of the JSON object under a key; empty if there is none. Throws as above if text is no JSON object.
std::optional<std::string> json_object(std::string_view what, std::string_view text, const std::string& key);

}  // namespace augicp
