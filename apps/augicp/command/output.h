// SPDX-License-Identifier: MIT
// Results as files, each whole or absent, also if a signal ends the command.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace augicp::app {

// Throws IoError.
void write_text_file(const std::string& path, const std::string& text);

// To a file, or to stdout for "-". Throws IoError.
void write_text(const std::string& destination, const std::string& text);

// The same for JSON, indented. Bytes that are not UTF-8 are replaced.
void write_json(const std::string& destination, const nlohmann::ordered_json& json);

}  // namespace augicp::app
