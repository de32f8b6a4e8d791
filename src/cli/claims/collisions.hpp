#pragma once

#include <CLI/App.hpp>
#include <string>

#include "collisions/certify.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell {

/// What `certify` is to prove, as it stands on the command line.
struct CertifyClaim {
    std::string ratio;
    std::string scene = "dumbbell";
    std::string section = "turning";
    std::string lemmas = "all";
    std::string gap = "1e-6";
};

/// Adds RATIO and the options of the claim to a command; `claim` outlives it. Returns RATIO's.
CLI::Option* add_claim_options(CLI::App& command, CertifyClaim& claim);

/// The claim as a request, with the standard number of jobs and no budget. Throws InputError if the options
/// contradict one another.
[[nodiscard]] CertifyRequest request_of(const CertifyClaim& claim, const RatioArgument& ratio);

}  // namespace dumbbell
