// SPDX-License-Identifier: MIT
// Results as files, each whole or absent, also if a signal ends the command.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace augicp::app {

// Throws IoError.
void write_text_file(const std::string& path, const std::string& text);

// To a file, or to stdout for "-". Throws IoError.
void write_text(const std::string& destination, const std::string& text);

// The same for JSON, indented. Bytes that are not UTF-8 are replaced.
void write_json(const std::string& destination, const nlohmann::ordered_json& json);

// What was written, for people: files separated by commas, without empty names and "-". A report that lacks its 3D
// views has the reason behind it.
std::string written_text(const std::vector<std::string>& files, const std::string& report);

}  // namespace augicp::app
