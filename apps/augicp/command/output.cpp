// SPDX-License-Identifier: MIT
#include "apps/augicp/command/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "apps/augicp/command/interruption.h"
#include "apps/augicp/page/report_bundle.h"
#include "augicp/core/error.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp::app {

void write_text_file(const std::string& path, const std::string& text) {
  write_whole([&] { write_file(path, text); });
}

void write_text(const std::string& destination, const std::string& text) {
  if (destination == "-")
    fmt::print("{}", text);
  else
    write_text_file(destination, text);
}

void write_json(const std::string& destination, const nlohmann::ordered_json& json) {
  write_text(destination, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void require_places(const std::vector<std::string>& files, const std::filesystem::path& to_be_made) {
  std::vector<std::filesystem::path> seen;
  std::error_code ignored;
  for (const std::filesystem::path file : files) {
    if (file.empty() || file == "-") continue;
    const std::filesystem::path folder = file.parent_path(), name = file.lexically_normal();
    if (std::filesystem::is_directory(file, ignored))
      throw IoError(fmt::format("{}: expected a file to write, found a folder", file.string()));
    const bool is_to_be_made =
        !to_be_made.empty() && (folder / "").lexically_normal() == (to_be_made / "").lexically_normal();
    if (!folder.empty() && !is_to_be_made && !std::filesystem::is_directory(folder, ignored))
      throw IoError(fmt::format("{}: cannot be written: there is no folder {}", file.string(), folder.string()));
    const bool is_device = std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored);
    if (!is_device && std::find(seen.begin(), seen.end(), name) != seen.end())
      throw std::invalid_argument(fmt::format("{}: two outputs would be written to it", file.string()));
    seen.push_back(name);
  }
}

void require_page_name(const std::string& page) {
  const std::string extension = lower_case_extension(page);
  for (const char* const other : {".pdf", ".png", ".jpg", ".svg", ".txt", ".md", ".json"})
    if (extension == other)
      throw std::invalid_argument(fmt::format("--report {}: a report is one HTML file; give {}", page,
                                              std::filesystem::path(page).replace_extension(".html").string()));
}

std::string written_text(const std::vector<std::string>& files, const std::string& report) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const std::string& file : files)
    if (!file.empty() && file != "-") add(file);
  if (report.empty()) return text;
  add(report);
  if (report_bundle().script.empty()) text += " (no 3D views: augicp was built without scripts/build-report)";
  return text;
}

}  // namespace augicp::app
