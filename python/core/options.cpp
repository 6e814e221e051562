// SPDX-License-Identifier: MIT
#include "python/core/options.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace augicp::python {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string quoted(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return text;
}

[[noreturn]] void refuse(const std::string& name, const char* expected, const py::handle& found) {
  throw WrongType(name + ": expected " + expected + ", found " + py::repr(found).cast<std::string>());
}

// Python accepts True as 1. Here it is a mistake. NumPy has its own bool.
bool is_bool(const py::handle& value) {
  return py::isinstance<py::bool_>(value) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

}  // namespace

void take(const std::string& name, const py::handle& value, double& field) {
  const bool is_number = !is_bool(value) && !PyUnicode_Check(value.ptr()) && PyNumber_Check(value.ptr()) != 0;
  const double number = is_number ? PyFloat_AsDouble(value.ptr()) : 0.0;
  if (!is_number || PyErr_Occurred()) {
    PyErr_Clear();
    refuse(name, "a number", value);
  }
  field = number;
}

void take(const std::string& name, const py::handle& value, int& field) {
  if (is_bool(value) || !PyIndex_Check(value.ptr())) refuse(name, "a whole number", value);
  int overflow = 0;
  const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const long number = whole ? PyLong_AsLongAndOverflow(whole.ptr(), &overflow) : 0;
  if (!whole) {
    PyErr_Clear();
    refuse(name, "a whole number", value);
  }
  if (overflow != 0 || number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
    throw std::invalid_argument(name + " = " + py::str(whole).cast<std::string>() + ": does not fit 32 bits");
  field = static_cast<int>(number);
}

void take(const std::string& name, const py::handle& value, bool& field) {
  if (!is_bool(value)) refuse(name, "True or False", value);
  field = PyObject_IsTrue(value.ptr()) == 1;
}

std::string taken_word(const std::string& name, const py::handle& value, const std::vector<std::string>& words) {
  if (!PyUnicode_Check(value.ptr())) refuse(name, ("one of " + joined(words)).c_str(), value);
  const char* const text = PyUnicode_AsUTF8(value.ptr());
  if (!text) PyErr_Clear();  // half a character: no word of ours
  const std::string word = text ? text : "";
  if (std::find(words.begin(), words.end(), word) != words.end()) return word;
  throw std::invalid_argument(name + ": expected one of " + joined(words) + ", found " +
                              py::repr(value).cast<std::string>());
}

void refuse_unknown(const std::string& name, const std::vector<std::string>& known) {
  const py::list near = py::module_::import("augicp._others").attr("near_options")(name, known);
  std::string text = "no option is called '" + name + "'";
  if (near.empty()) throw WrongType(text + "; there are " + joined(known));
  throw WrongType(text + "; did you mean " + joined(near.cast<std::vector<std::string>>()) + "?");
}

std::string literal_type(const std::vector<std::string>& words) { return "Literal[" + quoted(words) + "]"; }

std::string doc_line(const OptionText& text, const std::vector<std::string>& words) {
  constexpr std::size_t kColumn = 20;
  std::string line(text.name);
  line.resize(std::max(line.size() + 2, kColumn), ' ');
  return line + described(text, text.unit) + (words.empty() ? "" : ": " + quoted(words)) + "\n";
}

}  // namespace augicp::python
