#pragma once
// Linkages of any kind in the module kempe._core.

#include <pybind11/pybind11.h>

namespace kempe::python {

void add_linkages(pybind11::module_& module);

}  // namespace kempe::python
