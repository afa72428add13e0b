#pragma once
// Faults as Python takes them.

#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <variant>

#include "kempe/input_error.hpp"

namespace kempe::python {

/// A text that may quote a file of any bytes.
inline pybind11::str text_of(const std::string& quoting) {
  PyObject* text =
      PyUnicode_DecodeUTF8(quoting.data(), static_cast<pybind11::ssize_t>(quoting.size()), "replace");
  if (text == nullptr) throw pybind11::error_already_set();
  return pybind11::reinterpret_steal<pybind11::str>(text);
}

/// (file, line, key, found, allowed) of each fault.
inline pybind11::list faults_of(const InputError& first) {
  pybind11::list faults;
  const auto add = [&faults](const InputError& fault) {
    faults.append(pybind11::make_tuple(text_of(fault.file), fault.line, text_of(fault.key),
                                       text_of(fault.found), text_of(fault.allowed)));
  };
  add(first);
  for (const InputError& other : first.others) add(other);
  return faults;
}

/// The value, or the list of faults.
template <typename Value>
pybind11::object value_or_faults(std::variant<Value, InputError> found) {
  if (const auto* fault = std::get_if<InputError>(&found)) return faults_of(*fault);
  return pybind11::cast(std::move(std::get<Value>(found)));
}

}  // namespace kempe::python
