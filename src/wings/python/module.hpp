#pragma once

#include <pybind11/pybind11.h>

/// The module's parts; each adds its own names.
namespace dumbbell::python {

void add_certify(pybind11::module_& module);
void add_starts(pybind11::module_& module);
void add_verify(pybind11::module_& module);
void add_answers(pybind11::module_& module);

}  // namespace dumbbell::python
