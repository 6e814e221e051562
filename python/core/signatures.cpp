// SPDX-License-Identifier: MIT
#include "python/core/signatures.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

namespace augicp::python {
namespace {

namespace py = pybind11;

// Where a character of `wanted` stands outside of brackets and quotes, from `begin` on; npos: nowhere.
std::size_t find_outside(std::string_view text, std::string_view wanted, std::size_t begin) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (quote) {
      if (c == '\\') ++i;
      if (c == quote) quote = 0;
      continue;
    }
    if (depth == 0 && wanted.find(c) != std::string_view::npos) return i;
    if (c == '\'' || c == '"') quote = c;
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ')' || c == ']' || c == '}') --depth;
  }
  return std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string_view::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string_view> split(std::string_view parameters) {
  std::vector<std::string_view> parts;
  while (!parameters.empty()) {
    const std::size_t end = find_outside(parameters, ",", 0);
    parts.push_back(trimmed(parameters.substr(0, end)));
    parameters = end == std::string_view::npos ? "" : parameters.substr(end + 1);
  }
  return parts;
}

// "stamp: object = None" -> "stamp=None"
std::string without_type(std::string_view parameter) {
  const std::size_t colon = find_outside(parameter, ":=", 0), equals = find_outside(parameter, "=", 0);
  std::string text(trimmed(parameter.substr(0, colon)));
  if (equals != std::string_view::npos) text += '=' + std::string(trimmed(parameter.substr(equals + 1)));
  return text;
}

void append(const std::string& parameter, std::string& text) { text += (text.empty() ? "" : ", ") + parameter; }

// A value as it can be read back: infinity has no literal of its own.
std::string literal_of(const py::handle& value) {
  auto text = py::repr(value).cast<std::string>();
  const std::size_t infinity = text.find("inf");
  if (PyFloat_Check(value.ptr()) && infinity != std::string::npos) text.replace(infinity, 3, "1e999");
  return text;
}

// The options that are no parameters of their own yet.
void append_options(const py::dict& options, const std::vector<std::string>& taken, std::string& text) {
  bool has_mark = false;
  for (const auto& [name, value] : options) {
    const auto word = py::cast<std::string>(name);
    if (std::find(taken.begin(), taken.end(), word) != taken.end()) continue;
    if (!has_mark) append("*", text);
    has_mark = true;
    append(word + '=' + literal_of(value), text);
  }
}

void set_signature(PyObject* function, const py::dict& options) {
  if (!PyCFunction_Check(function)) return;
  PyMethodDef* const definition = reinterpret_cast<PyCFunctionObject*>(function)->m_ml;
  const std::string doc = definition->ml_doc ? definition->ml_doc : "";
  const std::size_t line_end = std::min(doc.find('\n'), doc.size());
  const std::string signature = text_signature(doc.substr(0, line_end), options);
  if (signature.empty()) return;
  const std::size_t body = std::min(doc.find_first_not_of('\n', line_end), doc.size());
  // pybind11 frees it like its own.
  char* const renewed = strdup((signature + "\n--\n\n" + doc.substr(body)).c_str());
  std::free(const_cast<char*>(definition->ml_doc));
  definition->ml_doc = renewed;
}

py::dict options_of(const py::dict& options, const std::string& name) {
  return options.contains(name.c_str()) ? options[name.c_str()].cast<py::dict>() : py::dict();
}

// Enumerations are Python's own classes, whose functions are not ours.
bool is_bound(const py::handle& type) {
  return PyType_Check(type.ptr()) && std::strcmp(Py_TYPE(type.ptr())->tp_name, "pybind11_type") == 0;
}

void set_signatures_of_class(const std::string& type_name, const py::handle& type, const py::dict& options) {
  const py::dict members(type.attr("__dict__"));
  for (const auto& [name, member] : members) {
    const std::string full_name = type_name + "." + py::cast<std::string>(name);
    const bool is_static = py::isinstance<py::staticmethod>(member);
    const py::object function =
        is_static ? py::object(member.attr("__func__")) : py::reinterpret_borrow<py::object>(member);
    const bool is_method = PyInstanceMethod_Check(function.ptr()) != 0;
    set_signature(is_method ? PyInstanceMethod_Function(function.ptr()) : function.ptr(),
                  options_of(options, full_name));
  }
}

}  // namespace

std::string text_signature(const std::string& line, const py::dict& options) {
  const std::size_t open = line.find('('), arrow = line.rfind(") -> ");
  if (open == std::string::npos || arrow == std::string::npos || arrow < open) return "";
  std::string text;
  std::vector<std::string> taken;
  for (const std::string_view part : split(std::string_view(line).substr(open + 1, arrow - open - 1))) {
    if (part.starts_with("**")) {
      append_options(options, taken, text);
      continue;
    }
    append(without_type(part), text);
    taken.emplace_back(part.substr(0, part.find(':')));
  }
  return line.substr(0, open) + '(' + text + ')';
}

void set_text_signatures(const py::module_& module, const py::dict& options) {
  const py::dict members(module.attr("__dict__"));
  for (const auto& [name, member] : members) {
    const auto word = py::cast<std::string>(name);
    if (is_bound(member)) {
      set_signatures_of_class(word, member, options);
    } else {
      set_signature(member.ptr(), options_of(options, word));
    }
  }
}

}  // namespace augicp::python
