#include <dumbbell/critical.hpp>
#include <dumbbell/law.hpp>
#include <dumbbell/trace.hpp>

#include "python/exact.hpp"
#include "python/module.hpp"
#include "python/proof.hpp"

namespace py = pybind11;

namespace dumbbell::python {
namespace {

using api::Collision;
using api::Trace;

constexpr const char* critical_text =
    R"(Encloses the critical ratio q_c(n), where N(q) steps from n - 1 to n, by Theorem 2: a pair of Decimals.

>>> lo, hi = critical(4, 20)
>>> print(lo, hi)
4.603338848751700352556 4.603338848751700352557
>>> certify(lo).upper, certify(hi).lower
(3, 4)

Every number between the two has the same first `digits` digits. TimeoutError: not within `budget`, in seconds.
)";

constexpr const char* law_text =
    R"(Bounds of N(q) by the law for every mass ratio: a pair of ints, which differ by one too near a step.

>>> law(10**24)
(885595129454, 885595129454)
)";

constexpr const char* trace_text =
    R"(Follows one initial condition, or a box of them, through all its collisions.

>>> orbit = trace(10, phi='1/3', phidot=2, y=2, ydot=-1)
>>> orbit.lower, orbit.upper
(3, 3)
>>> lo, hi = orbit.collisions[0].time

Each quantity is exact, as `q` of certify, or a pair (lo, hi); phi also '30deg' or 'pi/2'. Enclosures are pairs of
floats, rounded outward. `digits`: the precision; 0 is double precision.
)";

py::tuple critical(const Whole& n, const Whole& digits, const Budget& budget) {
    const auto ratio = running(api::CriticalOptions{.digits = digits}, budget,
                               [&](const auto& options) { return api::critical(n, options); });
    if (!ratio) {
        PyErr_SetString(PyExc_TimeoutError, "not enclosed within the budget, or with 16384 bits");
        throw py::error_already_set();
    }
    return py::make_tuple(decimal(ratio->lo), decimal(ratio->hi));
}

py::tuple law(const Number& q) {
    const api::MassRatio ratio(q.value);
    const api::Law found = running([&](const api::Stopped&) { return api::law(ratio); });
    return py::make_tuple(py::int_(py::str(found.least)), py::int_(py::str(found.most)));
}

Trace trace(const Number& q, const Number& phi, const Number& phidot, const Number& y, const Number& ydot,
            const Whole& digits) {
    const api::MassRatio ratio(q.value);
    const api::InitialCondition start{phi.value, phidot.value, y.value, ydot.value};
    return running([&](const api::Stopped& stopped) { return api::trace(ratio, start, digits, stopped); });
}

}  // namespace

void add_answers(py::module_& module) {
    py::class_<Collision>(module, "Collision", "One collision of every orbit of a box; enclosures are pairs.")
        .def_readonly("heavy", &Collision::heavy, "whether the heavy mass hits the floor")
        .def_readonly("time", &Collision::time)
        .def_readonly("phi", &Collision::phi)
        .def_readonly("y", &Collision::y)
        .def_readonly("phidot_before", &Collision::phidot_before)
        .def_readonly("phidot_after", &Collision::phidot_after)
        .def_readonly("ydot_before", &Collision::ydot_before)
        .def_readonly("ydot_after", &Collision::ydot_after)
        .def_readonly("grazing_sine", &Collision::grazing_sine)
        .def(by_members<Collision>(&Collision::heavy, &Collision::time, &Collision::phi, &Collision::y,
                                   &Collision::phidot_before, &Collision::phidot_after,
                                   &Collision::ydot_before, &Collision::ydot_after,
                                   &Collision::grazing_sine));
    py::class_<Trace>(module, "Trace", "The collisions of every orbit of a box.")
        .def_readonly("lower", &Trace::least, "every orbit has at least so many")
        .def_readonly("upper", &Trace::most, "and at most so many; None: nothing is known")
        .def_readonly("collisions", &Trace::collisions, "those that can be enclosed, in the order of time")
        .def(by_members<Trace>(&Trace::least, &Trace::most, &Trace::collisions))
        .def("__repr__", [](const Trace& t) {
            return "<Trace: " + std::to_string(t.least) +
                   (t.most ? " to " + std::to_string(*t.most) + " collisions>" : " collisions or more>");
        });
    module.def("critical", critical, critical_text, py::arg("n"), py::arg("digits") = 15, py::kw_only(),
               py::arg("budget") = py::none());
    module.def("law", law, law_text, py::arg("q"));
    module.def("trace", trace, trace_text, py::arg("q"), py::kw_only(), py::arg("phi"), py::arg("phidot"),
               py::arg("y"), py::arg("ydot"), py::arg("digits") = 0);
}

}  // namespace dumbbell::python
