#include "python/module.hpp"

#include <dumbbell/error.hpp>
#include <dumbbell/version.hpp>

namespace py = pybind11;

PYBIND11_MODULE(_dumbbell, module) {
    module.attr("__version__") = py::str(std::string(dumbbell::api::version));
    py::register_exception<dumbbell::api::InputError>(module, "InputError", PyExc_ValueError);
    py::register_exception<dumbbell::api::ResourceError>(module, "ResourceError", PyExc_RuntimeError);
    py::register_exception<dumbbell::api::BrokenInvariant>(module, "BrokenInvariant", PyExc_RuntimeError);
    dumbbell::python::add_verify(module);
    dumbbell::python::add_certify(module);
    dumbbell::python::add_starts(module);
    dumbbell::python::add_answers(module);
}
