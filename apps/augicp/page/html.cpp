// SPDX-License-Identifier: MIT
#include "apps/augicp/page/html.h"

namespace augicp::app {
namespace {

// Escapes a byte of UTF-8; bytes above 127 stay unchanged.
std::string escaped(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(c);
  const bool is_control = (code < 0x20 && c != '\n' && c != '\t') || code == 0x7f;
  return is_control ? "\xef\xbf\xbd" : std::string(1, c);
}

// A scrolling table would cut what html_explained() shows.
std::string heading(const Heading& heading) {
  const std::string name = escaped_html(heading.name);
  if (heading.meaning.empty()) return "<th>" + name + "</th>";
  return "<th><abbr title=\"" + escaped_html(heading.meaning) + "\">" + name + "</abbr></th>";
}

std::string row_html(const std::vector<std::string>& texts) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < texts.size(); ++i)
    row += (i == 0 ? "<th scope=\"row\">" : "<td>") + escaped_html(texts[i]) + (i == 0 ? "</th>" : "</td>");
  return row + "</tr>\n";
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string html;
  for (const char c : text) html += escaped(c);
  return html;
}

std::string json_in_html(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest = json.substr(i, 3);
    if (rest.front() == '<')
      text += "\\u003c";
    else if (rest.front() == '>')
      text += "\\u003e";
    else if (rest.front() == '&')
      text += "\\u0026";
    else if (rest == "\xe2\x80\xa8" || rest == "\xe2\x80\xa9") {  // U+2028, U+2029: line ends in JavaScript
      text += rest == "\xe2\x80\xa8" ? "\\u2028" : "\\u2029";
      i += 2;
    } else
      text += rest.front();
  }
  return text;
}

std::string html_list(const NamedTexts& rows) {
  std::string html = "<dl>\n";
  for (const auto& [name, text] : rows)
    html += "<div><dt>" + escaped_html(name) + "</dt><dd>" + escaped_html(text) + "</dd></div>\n";
  return html + "</dl>\n";
}

std::string html_explained(const std::string& name, const std::string& meaning) {
  if (meaning.empty()) return escaped_html(name);
  return "<span class=\"explained\" tabindex=\"0\">" + escaped_html(name) + "<span class=\"meaning\" role=\"note\">" +
         escaped_html(meaning) + "</span></span>";
}

std::string html_facts(const std::vector<Fact>& facts) {
  std::string html = "<dl>\n";
  for (const Fact& fact : facts)
    html +=
        "<div><dt>" + html_explained(fact.name, fact.meaning) + "</dt><dd>" + escaped_html(fact.text) + "</dd></div>\n";
  return html + "</dl>\n";
}

std::string html_table(const std::vector<Heading>& headings, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\"><table>\n<thead><tr>";
  for (const Heading& one : headings) html += heading(one);
  html += "</tr>\n</thead>\n<tbody>";
  for (const std::vector<std::string>& row : rows) html += row_html(row);
  return html + "</tbody></table></div>\n";
}

}  // namespace augicp::app
