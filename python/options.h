// SPDX-License-Identifier: MIT
// Keyword options: a table says which of a struct's fields a name stands for. Names, types and defaults all come from
// it and from the struct's default.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "augicp/core/words.h"
#include "python/errors.h"

namespace augicp::python {

namespace py = pybind11;

// One value. All throw WrongType, or std::invalid_argument for an unknown word; name is for the message.
void take(const std::string& name, const py::handle& value, double& field);
void take(const std::string& name, const py::handle& value, int& field);
void take(const std::string& name, const py::handle& value, bool& field);
void take_word(const std::string& name, const py::handle& value, const std::vector<std::string>& words,
               std::string& word);

template <typename Value>
void take(const std::string& name, const py::handle& value, std::optional<Value>& field) {
  field.reset();
  if (!value.is_none()) take(name, value, field.emplace());
}

// Throws WrongType: no option has this name, with the known ones that look like it.
[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<std::string>& known);

template <typename Options>
struct Option {
  std::function<void(const std::string&, const py::handle&, Options&)> set;
  std::function<py::object(const Options&)> value;
};
template <typename Options>
using OptionTable = std::map<std::string, Option<Options>>;

// field: what &Options::field or a lambda gives of an Options.
template <typename Options, typename Field>
Option<Options> number(Field field) {
  return {[field](const std::string& name, const py::handle& value, Options& options) {
            take(name, value, std::invoke(field, options));
          },
          [field](const Options& options) { return py::cast(std::invoke(field, options)); }};
}

template <typename Options, typename Value, typename Field>
Option<Options> word(const std::map<std::string, Value>& words, Field field) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) names.push_back(name);
  return {[=](const std::string& name, const py::handle& value, Options& options) {
            std::string chosen;
            take_word(name, value, names, chosen);
            std::invoke(field, options) = words.at(chosen);
          },
          [=](const Options& options) { return py::cast(word_for(words, std::invoke(field, options))); }};
}

// A word, or None for what is not set.
template <typename Options, typename Value, typename Field>
Option<Options> word_or_none(const std::map<std::string, Value>& words, Field field) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) names.push_back(name);
  return {[=](const std::string& name, const py::handle& value, Options& options) {
            std::invoke(field, options).reset();
            if (value.is_none()) return;
            std::string chosen;
            take_word(name, value, names, chosen);
            std::invoke(field, options) = words.at(chosen);
          },
          [=](const Options& options) -> py::object {
            const auto& chosen = std::invoke(field, options);
            return chosen ? py::cast(word_for(words, *chosen)) : py::none();
          }};
}

template <typename Options>
void set_options(const OptionTable<Options>& table, const py::dict& given, Options& options) {
  for (const auto& [key, value] : given) {
    const std::string name = py::cast<std::string>(key);
    const auto option = table.find(name);
    if (option == table.end()) {
      std::vector<std::string> known;
      for (const auto& [known_name, unused] : table) known.push_back(known_name);
      refuse_unknown(name, known);
    }
    option->second.set(name, value, options);
  }
}

template <typename Options>
py::dict values_of(const OptionTable<Options>& table, const Options& options) {
  py::dict values;
  for (const auto& [name, option] : table) values[py::str(name)] = option.value(options);
  return values;
}

}  // namespace augicp::python
