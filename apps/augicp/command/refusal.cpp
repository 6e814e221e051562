// SPDX-License-Identifier: MIT
#include "apps/augicp/command/refusal.h"

#include <fmt/core.h>

#include <cctype>
#include <optional>
#include <sstream>

#include "apps/augicp/command/own_words.h"
#include "apps/augicp/command/suggestion.h"

namespace augicp::app {
namespace {

// Two jobs, as of `align`: scans and depth images.
constexpr std::size_t kExamplesShown = 2;

// The lines of the help's footer that begin with the command's name.
std::vector<std::string> examples(const CLI::App& command) {
  std::istringstream lines(command.get_footer());
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  augicp ")) found.push_back(line);
  return found;
}

std::vector<std::string> subcommand_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : command.get_subcommands({})) names.push_back(subcommand->get_name());
  return names;
}

const CLI::App* subcommand_of(const CLI::App& command, const std::string& name) {
  for (const CLI::App* subcommand : command.get_subcommands({}))
    if (subcommand->get_name() == name) return subcommand;
  return nullptr;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  return names;
}

std::string meant(const std::string& suggestion, const std::string& prefix = "") {
  return suggestion.empty() ? "." : fmt::format(". Did you mean {}{}?", prefix, suggestion);
}

// The command that has an option of this name: the given one, or one right below it. Experiments are for few.
const CLI::App* owner_of(const CLI::App& command, const std::string& option) {
  if (command.get_option_no_throw(option)) return &command;
  for (const CLI::App* subcommand : command.get_subcommands({}))
    if (subcommand->get_option_no_throw(option)) return subcommand;
  return nullptr;
}

const CLI::App& root_of(const CLI::App& command) {
  return command.get_parent() ? root_of(*command.get_parent()) : command;
}

std::string unknown_option(const CLI::App& command, const std::string& option) {
  const std::string message = fmt::format("{} has no option {}", full_name(command), option);
  const CLI::App* owner = owner_of(root_of(command), option);
  const std::string near = meant(closest(option.substr(2), option_names(command)), "--");
  if (!owner) return message + near;
  if (owner->get_parent()) return message + fmt::format(". {} has it{}", full_name(*owner), near);
  return message + fmt::format(". It belongs before the subcommand: augicp {} ... {}", option, command.get_name());
}

// Options of one letter, and words behind one dash, belong to other programs: PCL and CloudCompare have them.
std::string unknown_letter(const CLI::App& command, const std::string& word) {
  const std::string near = word.size() > 3 ? closest(word.substr(1), option_names(command)) : "";
  if (!near.empty()) return fmt::format("{} has no option {}. Did you mean --{}?", full_name(command), word, near);
  constexpr std::size_t kMostNamed = 4;
  std::string names;
  std::size_t count = 0;
  for (const std::string& name : option_names(command))
    if (name.front() == word[1] && ++count <= kMostNamed) names += (names.empty() ? "--" : ", --") + name;
  const std::string message = fmt::format("{} has no option {}. Options are written out", full_name(command), word);
  return names.empty() || count > kMostNamed ? message + "." : message + ": " + names;
}

bool is_letter_option(const CLI::App& command, const std::string& word) {
  return word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1])) &&
         !command.get_option_no_throw(word.substr(0, 2));
}

// A word as a help or a version is asked for elsewhere.
std::string as_flag(const std::string& word) { return word == "help" || word == "version" ? "--" + word : ""; }

// Walks down to the subcommand that the words choose, and stops at the first word that means nothing.
struct Walk {
  const CLI::App* command;
  std::optional<std::string> problem;
};

Walk walk(const CLI::App& app, const std::vector<std::string>& words) {
  Walk at{&app, {}};
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    if (words[i].starts_with("--")) {
      const CLI::Option* option = at.command->get_option_no_throw(name);
      if (!option) return {at.command, unknown_option(*at.command, name)};
      if (option->get_items_expected_max() > 0 && name == words[i]) ++i;  // the value
    } else if (const CLI::App* next = subcommand_of(*at.command, words[i])) {
      at.command = next;
    } else if (is_letter_option(*at.command, words[i])) {
      return {at.command, unknown_letter(*at.command, words[i])};
    } else if (at.command->get_require_subcommand_min() > 0 && !words[i].starts_with("-")) {
      const std::vector<std::string> known = subcommand_names(*at.command);
      std::string list;
      for (const std::string& word : known) list += " " + word;
      const std::string flag = as_flag(words[i]);
      return {at.command, fmt::format("{} has no subcommand {}{} There are:{}.", full_name(*at.command), words[i],
                                      meant(flag.empty() ? closest(words[i], known) : flag), list)};
    }
  }
  return at;
}

}  // namespace

std::string overview(const CLI::App& app) {
  std::string text = app.get_description() + "\n";
  for (const CLI::App* subcommand : app.get_subcommands({})) {
    text += fmt::format("\n{}\n", subcommand->get_description());
    const std::vector<std::string> lines = examples(*subcommand);
    for (std::size_t i = 0; i < lines.size() && i < kExamplesShown; ++i) text += lines[i] + "\n";
  }
  return text + "\naugicp --help lists the subcommands and exit codes, augicp SUBCOMMAND --help the options.\n";
}

std::string refusal(const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error) {
  const Walk at = walk(app, words);
  std::string text = fmt::format("augicp: {}\n", at.problem ? *at.problem : in_own_words(*at.command, error));
  const std::vector<std::string> lines = examples(*at.command);
  if (!at.problem && dynamic_cast<const CLI::RequiredError*>(&error) && !lines.empty())
    text += "For example:\n" + lines.front() + "\n";
  return text + fmt::format("Run {} --help for all options.\n", full_name(*at.command));
}
}  // namespace augicp::app
