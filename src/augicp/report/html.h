// SPDX-License-Identifier: MIT
// Text from outside, file names above all, as HTML that says just that text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace augicp {

// For element content and for attributes in double quotes. Control characters, which HTML has no word for, become
// U+FFFD.
std::string escaped_html(std::string_view text);

// JSON as the content of a <script> element: neither a tag nor a comment can begin in it, and it stays JSON.
std::string json_in_html(std::string_view json);

// A table of names and values; of all, escaped here.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;
std::string html_list(const NamedTexts& rows);

// With a line of headings; the first column is a name, the others are numbers.
std::string html_table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

}  // namespace augicp
