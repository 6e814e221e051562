// SPDX-License-Identifier: MIT
// One complete HTML file: it needs no other file and no network, and its policy forbids both.
#pragma once

#include <string>
#include <string_view>

namespace augicp::app {

// Parts shared by all reports, made at build time. Without a script the page shows its body only.
struct PageBundle {
  std::string_view style;
  std::string_view script;         // empty: none
  std::string_view script_sha256;  // base64; the browser refuses every other script
};

struct Page {
  std::string title;  // text
  std::string body;   // HTML: complete without the script
  std::string data;   // JSON for the script
};

// The same page gives the same bytes: no time, no machine.
std::string to_html(const Page& page, const PageBundle& bundle);

}  // namespace augicp::app
