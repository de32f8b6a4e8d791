#include <dumbbell/starts.hpp>

#include "python/exact.hpp"
#include "python/module.hpp"
#include "python/proof.hpp"

namespace py = pybind11;

namespace dumbbell::python {
namespace {

constexpr const char* starts_text =
    R"(Proves how many starts of a box have how many collisions: it is halved until every part has its exact number.

>>> box = certify_starts(10, phi=(0, 3), phidot=0, y=2, ydot=(-2, -1), boxes=500)
>>> box.lower, box.upper
(1, 4)
>>> bool(box.verify())
True

Each quantity is exact, as `q` of certify, or a pair (lo, hi); phi also '30deg' or 'pi/2'. `boxes`: at most so many
parts. `digits`: for parts that double precision does not decide. `budget`: seconds.
)";

constexpr const char* incoming_text =
    R"(The same of all trajectories that come in from above, by their natural measure.

>>> lo, hi = certify_incoming(10, boxes=500).mean
>>> float(lo) < mean_collisions(10)[0] < float(hi)
True
)";

constexpr const char* mean_text =
    R"(Encloses the mean number of collisions of all incoming trajectories, (E(-q) + E(-1/q))/pi: Theorem 6.

>>> mean_collisions(1)
(1.2160067234249796, 1.2160067234249798)
)";

using Starts = api::StartsProof;

py::list shares_of(const Starts& starts) {
    py::list shares;
    for (const api::StartsShare& share : starts.shares) {
        shares.append(py::make_tuple(share.least, share.most, fraction(share.lo), fraction(share.hi)));
    }
    return shares;
}

py::tuple mean_of(const Starts& starts) {
    const auto& hi = starts.mean_hi;
    return py::make_tuple(fraction(starts.mean_lo), hi ? fraction(*hi) : py::object(py::none()));
}

Starts certify_starts(const Number& q, const Number& phi, const Number& phidot, const Number& y,
                      const Number& ydot, const Whole& boxes, const Whole& digits, const Whole& jobs,
                      const Budget& budget) {
    const api::MassRatio ratio(q.value);
    const api::InitialCondition box{phi.value, phidot.value, y.value, ydot.value};
    return running(api::StartsOptions{.boxes = boxes, .digits = digits, .jobs = jobs}, budget,
                   [&](const auto& options) { return api::certify_starts(ratio, box, options); });
}

Starts certify_incoming(const Number& q, const Whole& boxes, const Whole& jobs, const Budget& budget) {
    const api::MassRatio ratio(q.value);
    return running(api::StartsOptions{.boxes = boxes, .jobs = jobs}, budget,
                   [&](const auto& options) { return api::certify_incoming(ratio, options); });
}

}  // namespace

void add_starts(py::module_& module) {
    using Share = api::StartsShare;
    py::class_<Share>(module, "_Share")
        .def(by_members<Share>(&Share::least, &Share::most, &Share::lo, &Share::hi));
    certificate_class<Starts>(module, "StartsCertificate",
                              "A proof of how many starts have how many collisions.")
        .def_readonly("lower", &Starts::least, "every start has at least this number")
        .def_readonly("upper", &Starts::most, "and at most this; None: nothing is known")
        .def_property_readonly(
            "shares", shares_of,
            "(k, k2, lo, hi): k to k2 collisions (None: no end) have a share from lo to hi")
        .def_property_readonly("mean", mean_of, "the pair (lo, hi) of bounds; hi is None if there is none")
        .def_property_readonly(
            "undecided", [](const Starts& s) { return fraction(s.undecided); }, "the share of the box")
        .def(
            "svg", [](const Starts& s) { return api::picture(s); },
            "A map of the starts: exactly two quantities are intervals.")
        .def(by_members<Starts>(&Starts::least, &Starts::most, &Starts::shares, &Starts::undecided,
                                &Starts::mean_lo, &Starts::mean_hi, &Starts::certificate, &Starts::sha256,
                                &Starts::demand));
    module.def("certify_starts", certify_starts, starts_text, py::arg("q"), py::kw_only(), py::arg("phi"),
               py::arg("phidot"), py::arg("y"), py::arg("ydot"), py::arg("boxes") = 50000,
               py::arg("digits") = 0, py::arg("jobs") = 1, py::arg("budget") = py::none());
    module.def("certify_incoming", certify_incoming, incoming_text, py::arg("q"), py::kw_only(),
               py::arg("boxes") = 50000, py::arg("jobs") = 1, py::arg("budget") = py::none());
    module.def(
        "mean_collisions", [](const Number& q) { return api::mean_collisions(api::MassRatio(q.value)); },
        mean_text, py::arg("q"));
}

}  // namespace dumbbell::python
