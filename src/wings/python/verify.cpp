#include <dumbbell/verify.hpp>

#include "python/exact.hpp"
#include "python/module.hpp"
#include "python/proof.hpp"
#include "python/running.hpp"

namespace py = pybind11;

namespace dumbbell::python {
namespace {

using api::Claim;
using api::Verification;

constexpr const char* verify_text =
    R"(Asks the independent verifier whether a certificate proves a claim.

The certificate is bytes, or the path of a file. The claim: for every mass ratio of `ratio` (None: those of the file) no
trajectory has more than `most` collisions, and some trajectory has `least`; `exactly` is both. Without a bound any will
do. `kind` is 'collisions', or another kind of claim ('law', 'incoming', ...); None: 'collisions', or of a call without a
claim what the file is about. Whatever else dumbbell-verify can be asked has its name: `gap`, `gaps`, `heavy_at_most`,
`scene`, `rho`, `inertia`, `coin`, `rod_mass`, `phi`, `decided`, `delta` and so on, as `dumbbell-verify --help` says;
each is an exact number, a pair of them, or text. `budget`: seconds of a core, about, that it may cost; None: no limit.

>>> ten = certify(10)
>>> bool(verify(ten.bytes, ratio=10, exactly=4))
True
>>> verify(ten.bytes, ratio=10, exactly=3).verdict
'rejected'
>>> bool(verify(certify((1, 100)).bytes, ratio=(1, 100), most=10, gap='1e-6', gaps=8))
True
)";

Verification verify(const py::object& certificate, const Whole& jobs, const Budget& budget,
                    const py::kwargs& claims) {
    const auto demand = taken<std::string>("demand", claims);
    const Claim claim{.kind = demand.empty() ? std::optional(std::string()) : std::nullopt, .demand = demand};
    PyObject* const given = certificate.ptr();
    const bool in_memory =
        PyBytes_Check(given) != 0 || PyByteArray_Check(given) != 0 || PyMemoryView_Check(given) != 0;
    const auto content = in_memory ? certificate.cast<Content>().value : certificate.cast<Path>().value;
    const std::string time = budget ? std::to_string(budget->value) + "s" : "100h";
    return running([&](const api::Stopped& stopped) {
        return in_memory ? api::verify_text(content, claim, jobs, time, stopped)
                         : api::verify(content, claim, jobs, time, stopped);
    });
}

}  // namespace

void add_verify(py::module_& module) {
    py::class_<Verification>(module, "Verification", "What the verifier says; true if it has verified.")
        .def_readonly("verdict", &Verification::verdict)
        .def(by_members<Verification>(&Verification::verdict, &Verification::text, &Verification::sha256))
        .def_readonly("text", &Verification::text, "what is proved, or what is wrong, and where")
        .def_readonly("sha256", &Verification::sha256, "of a verified certificate")
        .def("__bool__", [](const Verification& v) { return static_cast<bool>(v); })
        .def("__repr__", [](const Verification& v) {
            return "<Verification " + py::cast(v.verdict).cast<std::string>() + ": " + v.text + ">";
        });
    module.def("verify", verify, verify_text, py::arg("certificate"), py::kw_only(), py::arg("jobs") = 1,
               py::arg("budget") = 30);
}

}  // namespace dumbbell::python
