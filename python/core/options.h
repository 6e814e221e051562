// SPDX-License-Identifier: MIT
// Keyword options of a table of the library, see augicp/core/option.h: names, types, defaults and help come from there.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "augicp/core/option.h"
#include "python/core/errors.h"

namespace augicp::python {

namespace py = pybind11;

// One value. All throw WrongType, or std::invalid_argument for an unknown word; name is for the message.
void take(const std::string& name, const py::handle& value, double& field);
void take(const std::string& name, const py::handle& value, int& field);
void take(const std::string& name, const py::handle& value, bool& field);
std::string taken_word(const std::string& name, const py::handle& value, const std::vector<std::string>& words);

template <HasWords Value>
std::vector<std::string> words_of() {
  std::vector<std::string> words;
  for (const auto& [value, word] : kWords<Value>) words.emplace_back(word);
  return words;
}

template <HasWords Value>
void take(const std::string& name, const py::handle& value, Value& field) {
  field = *value_of<Value>(taken_word(name, value, words_of<Value>()));
}

template <typename Value>
void take(const std::string& name, const py::handle& value, std::optional<Value>& field) {
  field.reset();
  if (!value.is_none()) take(name, value, field.emplace());
}

template <typename Value>
py::object object_of(const Value& field) {
  if constexpr (HasWords<Value>)
    return py::str(std::string(name_of(field)));
  else
    return py::cast(field);
}

template <typename Value>
py::object object_of(const std::optional<Value>& field) {
  return field ? object_of(*field) : py::none();
}

// Throws WrongType: no option has this name; the message lists similar ones.
[[noreturn]] void refuse_unknown(const std::string& name, const std::vector<std::string>& known);

template <typename Options>
void set_option(const std::string& name, const py::handle& value, Options& options) {
  std::vector<std::string> known;
  bool is_known = false;
  for_each_option(options, [&](const OptionText& text, auto& field) {
    known.emplace_back(text.name);
    if (name != text.name) return;
    is_known = true;
    take(name, value, field);
  });
  if (!is_known) refuse_unknown(name, known);
}

template <typename Options>
void set_options(const py::dict& given, Options& options) {
  for (const auto& [name, value] : given) set_option(py::cast<std::string>(name), value, options);
}

// Every option by its name, as it is set.
template <typename Options>
py::dict values_of(const Options& options) {
  py::dict values;
  for_each_option(options, [&](const OptionText& text, const auto& field) {
    values[py::str(text.name.data(), text.name.size())] = object_of(field);
  });
  return values;
}

// Types of fields, as the stub has them.
inline std::string type_of(double) { return "float"; }
inline std::string type_of(int) { return "int"; }
inline std::string type_of(bool) { return "bool"; }

// Literal["augmented", "gicp", "plane", "point", "ndt"]
std::string literal_type(const std::vector<std::string>& words);

template <HasWords Value>
std::string type_of(Value) {
  return literal_type(words_of<Value>());
}
template <typename Value>
std::string type_of(const std::optional<Value>&) {
  return "Optional[" + type_of(Value{}) + "]";
}

template <typename Options>
py::dict types_of(const Options& options) {
  py::dict types;
  for_each_option(options, [&](const OptionText& text, const auto& field) {
    types[py::str(text.name.data(), text.name.size())] = type_of(field);
  });
  return types;
}

// A line of a docstring. words: the choices, if it has some.
std::string doc_line(const OptionText& text, const std::vector<std::string>& words);

template <typename Value>
std::vector<std::string> choices_of(const Value&) {
  if constexpr (HasWords<Value>) return words_of<Value>();
  return {};
}
template <typename Value>
std::vector<std::string> choices_of(const std::optional<Value>&) {
  return choices_of(Value{});
}

// Every option, one a line, for a docstring.
template <typename Options>
std::string options_doc() {
  std::string doc;
  const Options options;
  for_each_option(options,
                  [&](const OptionText& text, const auto& field) { doc += doc_line(text, choices_of(field)); });
  return doc;
}

}  // namespace augicp::python
