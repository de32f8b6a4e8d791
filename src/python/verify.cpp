#include <pybind11/stl.h>

#include <dumbbell/verify.hpp>

#include "python/exact.hpp"
#include "python/module.hpp"
#include "python/running.hpp"

namespace py = pybind11;

namespace dumbbell::python {
namespace {

using api::Claim;
using api::Verification;

constexpr const char* verify_text =
    R"(Asks the independent verifier whether a certificate proves a claim.

The certificate is bytes, or the path of a file. The claim: for every mass ratio of `ratio` no trajectory has more than
`most` collisions, and some trajectory has `least`; `exactly` is both. Without a bound any will do. `kind` is
'collisions', or another claim of dumbbell-verify --claim. `budget`: seconds of a core, about, that it may cost.

>>> ten = certify(10)
>>> bool(verify(ten.bytes, ratio=10, exactly=4))
True
>>> verify(ten.bytes, ratio=10, exactly=3).verdict
'rejected'
)";

const char* name_of(api::Verdict verdict) {
    switch (verdict) {
        case api::Verdict::verified:
            return "verified";
        case api::Verdict::rejected:
            return "rejected";
        case api::Verdict::unsupported:
            return "unsupported";
        case api::Verdict::unreadable:
            return "unreadable";
        case api::Verdict::limit:
            return "limit";
        case api::Verdict::open:
            break;
    }
    return "open";
}

Verification verify(const py::object& certificate, const py::object& ratio,
                    std::optional<std::uint64_t> exactly, std::optional<std::uint64_t> most,
                    std::optional<std::uint64_t> least, const std::string& kind, unsigned jobs,
                    unsigned budget) {
    if (exactly && (most || least)) {
        throw py::value_error("exactly is most and least: give it without them");
    }
    const Claim claim{.ratio = ratio.is_none() ? "" : exact_text(ratio),
                      .most = exactly ? exactly : most,
                      .least = exactly ? exactly : least,
                      .kind = kind};
    const bool in_memory = py::isinstance<py::bytes>(certificate);
    const py::object path =
        in_memory ? py::object() : py::module_::import("os").attr("fsdecode")(certificate);
    const auto content = (in_memory ? certificate : path).cast<std::string>();
    const std::string time = std::to_string(budget) + "s";
    return running([&](const api::Stopped& stopped) {
        return in_memory ? api::verify_text(content, claim, jobs, time, stopped)
                         : api::verify(content, claim, jobs, time, stopped);
    });
}

}  // namespace

void add_verify(py::module_& module) {
    py::class_<Verification>(module, "Verification", "What the verifier says; true if it has verified.")
        .def_property_readonly("verdict", [](const Verification& v) { return name_of(v.verdict); })
        .def_readonly("text", &Verification::text, "what is proved, or what is wrong, and where")
        .def_readonly("sha256", &Verification::sha256, "of a verified certificate")
        .def("__bool__", [](const Verification& v) { return static_cast<bool>(v); })
        .def("__repr__", [](const Verification& v) {
            return "<Verification " + std::string(name_of(v.verdict)) + ": " + v.text + ">";
        });
    module.def("verify", verify, verify_text, py::arg("certificate"), py::kw_only(),
               py::arg("ratio") = py::none(), py::arg("exactly") = py::none(), py::arg("most") = py::none(),
               py::arg("least") = py::none(), py::arg("kind") = "collisions", py::arg("jobs") = 1,
               py::arg("budget") = 30);
}

}  // namespace dumbbell::python
