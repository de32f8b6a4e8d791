#include "python/module.hpp"

#include <pthread.h>

#include <cstring>
#include <dumbbell/error.hpp>
#include <dumbbell/version.hpp>
#include <stdexcept>

#include "python/running.hpp"

namespace py = pybind11;

namespace {

/// Raises the exception of that name; a message may hold the name of a file, of any bytes.
void raise(const char* name, const std::exception& error) {
    const auto length = static_cast<Py_ssize_t>(std::strlen(error.what()));
    const auto message =
        py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(error.what(), length, "surrogateescape"));
    PyErr_SetObject(py::module_::import("dumbbell._dumbbell").attr(name).ptr(), message.ptr());
}

void translate(std::exception_ptr thrown) try {
    std::rethrow_exception(thrown);
} catch (const dumbbell::api::InputError& error) {
    raise("InputError", error);
} catch (const std::invalid_argument& error) {  // of the verifier
    raise("InputError", error);
} catch (const dumbbell::api::ResourceError& error) {
    raise("ResourceError", error);
} catch (const dumbbell::api::BrokenInvariant& error) {
    raise("BrokenInvariant", error);
}

py::object add_exception(py::module_& module, const std::string& name, const py::object& bases) {
    auto type = py::reinterpret_steal<py::object>(
        PyErr_NewException(("dumbbell._dumbbell." + name).c_str(), bases.ptr(), nullptr));
    module.attr(name.c_str()) = type;
    return type;
}

}  // namespace

PYBIND11_MODULE(_dumbbell, module) {
    module.attr("__version__") = py::str(std::string(dumbbell::api::version));
    const py::handle value_error(PyExc_ValueError), type_error(PyExc_TypeError), run_time(PyExc_RuntimeError);
    const py::object input_error = add_exception(module, "InputError", py::make_tuple(value_error));
    add_exception(module, "_InputTypeError", py::make_tuple(input_error, type_error));
    add_exception(module, "ResourceError", py::make_tuple(run_time));
    add_exception(module, "BrokenInvariant", py::make_tuple(run_time));
    py::register_local_exception_translator(translate);
    ::pthread_atfork(nullptr, nullptr, dumbbell::python::Outside::forked);
    module.def("_interpreter_ends", dumbbell::python::Outside::interpreter_ends);
    dumbbell::python::add_verify(module);
    dumbbell::python::add_certify(module);
    dumbbell::python::add_starts(module);
    dumbbell::python::add_answers(module);
}
