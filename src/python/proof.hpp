#pragma once

#include <pybind11/pybind11.h>

#include <dumbbell/error.hpp>
#include <dumbbell/picture.hpp>
#include <dumbbell/verify.hpp>
#include <string>

#include "python/running.hpp"

/// What certificates of every kind do.
namespace dumbbell::python {

/// Asks the verifier for just what a certificate says.
inline api::Verification verify_itself(const std::string& certificate, api::Claim claim, long least,
                                       std::optional<long> most, unsigned jobs) {
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

/// A budget in seconds.
template <class Options>
Options within(Options options, const std::optional<double>& budget) {
    if (budget) {
        options.budget = std::chrono::duration<double>(*budget);
    }
    return options;
}

}  // namespace dumbbell::python
