#include "python/exact.hpp"

namespace py = pybind11;

namespace dumbbell::python {

std::string exact_text(const py::handle& number) {
    if (py::isinstance<py::str>(number)) {
        return number.cast<std::string>();
    }
    if (py::isinstance<py::tuple>(number) && py::len(number) == 2) {
        const auto ends = py::reinterpret_borrow<py::tuple>(number);
        return exact_text(ends[0]) + ":" + exact_text(ends[1]);
    }
    if (!py::isinstance<py::bool_>(number)) {
        if (py::hasattr(number, "as_integer_ratio")) {
            const py::tuple ratio = number.attr("as_integer_ratio")();
            return py::str(ratio[0]).cast<std::string>() + "/" + py::str(ratio[1]).cast<std::string>();
        }
        if (PyIndex_Check(number.ptr()) != 0) {
            return py::str(number.attr("__index__")()).cast<std::string>();
        }
    }
    throw py::type_error(py::repr(number).cast<std::string>() +
                         " is no exact number: give an int, a Fraction, a Decimal, a float, text such as "
                         "'9/2' or '1:100', or a pair (lo, hi)");
}

py::object fraction(const std::string& text) {
    return py::module_::import("fractions").attr("Fraction")(text);
}

py::object decimal(const std::string& text) { return py::module_::import("decimal").attr("Decimal")(text); }

py::object whole(const std::string& digits) { return py::int_(py::str(digits)); }

}  // namespace dumbbell::python
