// SPDX-License-Identifier: MIT
#include "apps/augicp/page/page.h"

#include "apps/augicp/page/html.h"

namespace augicp::app {
namespace {

std::string policy(const PageBundle& bundle) {
  std::string rules = "default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:";
  if (!bundle.script.empty()) rules += "; script-src 'sha256-" + std::string(bundle.script_sha256) + "'";
  return rules;
}

}  // namespace

std::string to_html(const Page& page, const PageBundle& bundle) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += "<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy(bundle) + "\">\n";
  html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += "<meta name=\"color-scheme\" content=\"light dark\">\n";
  html += "<title>" + escaped_html(page.title) + "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n";
  html += std::string(bundle.style) + "</style>\n</head>\n<body>\n" + page.body;
  if (!bundle.script.empty()) {
    html += "<script type=\"application/json\" id=\"report\">" + json_in_html(page.data) + "</script>\n";
    html += "<script>" + std::string(bundle.script) + "</script>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace augicp::app
