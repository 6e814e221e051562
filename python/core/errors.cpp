// SPDX-License-Identifier: MIT
#include "python/core/errors.h"

#include "augicp/core/error.h"
#include "python/bindings.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

// Borrowed from the module, which is never unloaded.
struct ErrorClasses {
  PyObject* argument = PyExc_ValueError;
  PyObject* type = PyExc_TypeError;
  PyObject* file = PyExc_OSError;
};
ErrorClasses classes;

PyObject* add_class(py::module_& module, const char* name, const char* doc, const py::tuple& bases) {
  const std::string full_name = std::string("augicp.") + name;
  const auto made =
      py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), nullptr));
  if (!made) throw py::error_already_set();
  module.attr(name) = made;
  return made.ptr();
}

// A message may contain a file name that is not UTF-8; Python can represent such bytes.
void raise(PyObject* error_class, const char* message) {
  const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(message));
  if (text) PyErr_SetObject(error_class, text.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const WrongType& error) {
    raise(classes.type, error.what());
  } catch (const IoError& error) {
    raise(classes.file, error.what());
  } catch (const std::invalid_argument& error) {
    raise(classes.argument, error.what());
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  const auto base = py::reinterpret_borrow<py::object>(add_class(module, "Error",
                                                                 "The base of everything that augicp raises by itself.",
                                                                 py::make_tuple(py::handle(PyExc_Exception))));
  classes.argument = add_class(module, "ArgumentError", "An argument or option out of its range. Also a ValueError.",
                               py::make_tuple(base, py::handle(PyExc_ValueError)));
  classes.type = add_class(module, "ArgumentTypeError",
                           "An argument of a kind that cannot be used, or an unknown option. Also a TypeError.",
                           py::make_tuple(base, py::handle(PyExc_TypeError)));
  classes.file = add_class(module, "FileError",
                           "A file that cannot be read or written as asked: the message names the file, the line or "
                           "byte, what was expected and what was found. Also an OSError.",
                           py::make_tuple(base, py::handle(PyExc_OSError)));
  py::register_local_exception_translator(&translate);
}

}  // namespace augicp::python
