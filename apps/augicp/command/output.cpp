// SPDX-License-Identifier: MIT
#include "apps/augicp/command/output.h"

#include <fmt/core.h>

#include "apps/augicp/command/interruption.h"
#include "apps/augicp/page/report_bundle.h"
#include "augicp/io/atomic_file.h"

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
