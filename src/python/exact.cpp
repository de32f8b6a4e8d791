#include "python/exact.hpp"

namespace py = pybind11;

namespace dumbbell::python {

py::object fraction(const std::string& text) {
    return py::module_::import("fractions").attr("Fraction")(text);
}

py::object decimal(const std::string& text) { return py::module_::import("decimal").attr("Decimal")(text); }

py::object whole(const std::string& digits) { return py::int_(py::str(digits)); }

}  // namespace dumbbell::python
