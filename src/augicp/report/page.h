// SPDX-License-Identifier: MIT
// One HTML file that needs nothing else: no other file, and no network, which it forbids itself.
#pragma once

#include <string>
#include <string_view>

namespace augicp {

// What is the same in every report. Made at build time; without a script the page is what its body says.
struct PageBundle {
  std::string_view style;
  std::string_view script;         // empty: none
  std::string_view script_sha256;  // base64; the browser runs no other script
};

struct Page {
  std::string title;  // text
  std::string body;   // HTML: complete without the script
  std::string data;   // JSON for the script
};

// The same bytes for the same page: no time, no machine.
std::string to_html(const Page& page, const PageBundle& bundle);

}  // namespace augicp
