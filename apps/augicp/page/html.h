// SPDX-License-Identifier: MIT
// Text from outside, such as file names, as HTML that shows exactly this text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace augicp::app {

// For element content and for attributes in double quotes. Control characters, which HTML cannot represent, become
// U+FFFD.
std::string escaped_html(std::string_view text);

// JSON as the content of a <script> element: no tag or comment can begin in it, and it remains valid JSON.
std::string json_in_html(std::string_view json);

// A table of names and values; both are escaped here.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;
std::string html_list(const NamedTexts& rows);

// A value, and what it means in a sentence, which shows at the pointer, with the focus, and to screen readers.
struct Fact {
  std::string name, text, meaning;
};
std::string html_facts(const std::vector<Fact>& facts);

// A name followed by its meaning, as in a fact.
std::string html_explained(const std::string& name, const std::string& meaning);

// With a row of headings; the first column is a name, the others are numbers.
struct Heading {
  std::string name, meaning;
  Heading(std::string text, std::string sentence = {}) : name(std::move(text)), meaning(std::move(sentence)) {}
  Heading(const char* text) : name(text) {}
};
std::string html_table(const std::vector<Heading>& headings, const std::vector<std::vector<std::string>>& rows);

}  // namespace augicp::app
