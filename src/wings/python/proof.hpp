#pragma once

#include <pybind11/pybind11.h>

#include <dumbbell/error.hpp>
#include <dumbbell/picture.hpp>
#include <dumbbell/verify.hpp>
#include <string>

#include "python/exact.hpp"
#include "python/running.hpp"

/// What certificates of every kind do.
namespace dumbbell::python {

/// Asks the verifier for all that a certificate says.
template <class Proof>
api::Verification verify_itself(const Proof& proof, const Whole& jobs) {
    return running([&](const api::Stopped& stopped) {
        return api::verify_text(proof.certificate, {.demand = proof.demand}, jobs, "100h", stopped);
    });
}

/// For notebooks, where no picture is no error.
template <class Proof>
pybind11::object picture_or_none(const Proof& proof) try {
    return pybind11::str(api::picture(proof));
} catch (const api::InputError&) {
    return pybind11::none();
}

/// What every certificate has.
template <class Proof>
pybind11::class_<Proof> certificate_class(const pybind11::module_& module, const char* name,
                                          const char* text) {
    return pybind11::class_<Proof>(module, name, text)
        .def_property_readonly("bytes", [](const Proof& p) { return pybind11::bytes(p.certificate); })
        .def_readonly("sha256", &Proof::sha256, "as the last line has it")
        .def_readonly("demand", &Proof::demand, "all that it says, as dumbbell-verify demands it")
        .def("verify", verify_itself<Proof>,
             "Asks the independent verifier for all that the certificate says.", pybind11::kw_only(),
             pybind11::arg("jobs") = 1)
        .def("__repr__", [name](const Proof& p) { return "<" + std::string(name) + ": " + p.demand + ">"; })
        .def("_repr_svg_", picture_or_none<Proof>);
}

/// work(options), within the budget, while Ctrl-C ends it.
template <class Options, class Work>
auto running(Options options, const Budget& budget, const Work& work) {
    if (budget) {
        options.budget = std::chrono::duration<double>(budget->value);
    }
    return running([&](const api::Stopped& stopped) {
        options.stopped = stopped;
        return work(options);
    });
}

/// Pickles, and copies, by these members.
template <class T, class... Members>
auto by_members(Members... members) {
    return pybind11::pickle(
        [=](const T& x) { return pybind11::make_tuple(x.*members...); },
        [=](const pybind11::tuple& state) {
            T x;
            std::size_t i = 0;
            ((x.*members = state[i++].template cast<std::decay_t<decltype(x.*members)>>()), ...);
            return x;
        });
}

}  // namespace dumbbell::python
