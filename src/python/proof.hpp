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

/// Asks the verifier for just what a certificate says.
inline api::Verification verify_itself(const std::string& certificate, api::Claim claim, long least,
                                       std::optional<long> most, const Whole& jobs) {
    claim.least = static_cast<std::uint64_t>(least);
    if (most) {
        claim.most = static_cast<std::uint64_t>(*most);
    }
    return running([&](const api::Stopped& stopped) {
        return api::verify_text(certificate, claim, jobs, "100h", stopped);
    });
}

/// For notebooks, where no picture is no error.
template <class Proof>
pybind11::object picture_or_none(const Proof& proof) try {
    return pybind11::str(api::picture(proof));
} catch (const api::InputError&) {
    return pybind11::none();
}

template <class Options>
Options within(Options options, const Budget& budget) {
    if (budget) {
        options.budget = std::chrono::duration<double>(budget->value);
    }
    return options;
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
