// SPDX-License-Identifier: MIT
// Results as files, each whole or absent, also if a signal ends the command.
#pragma once

#include <filesystem>
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

// Before the work, whose result would be lost: the folder of each file exists, none is a folder, and no two are the
// same file. Empty names and "-" are left out. Throws IoError or std::invalid_argument.
// to_be_made: a folder that the command makes first; what is to be written into it has a place.
void require_places(const std::vector<std::string>& files, const std::filesystem::path& to_be_made = {});

// Refuses a report of a name that stands for another kind of document.
void require_page_name(const std::string& page);

// What was written, for people: files separated by commas, without empty names and "-". A report that lacks its 3D
// views has the reason behind it.
std::string written_text(const std::vector<std::string>& files, const std::string& report);

}  // namespace augicp::app
