// SPDX-License-Identifier: MIT
#include "apps/augicp/command/output.h"

#include <fmt/core.h>

#include "apps/augicp/command/interruption.h"
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

}  // namespace augicp::app
