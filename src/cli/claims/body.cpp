#include "cli/claims/body.hpp"

#include "base/error.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

collisions::Claim rod_of(const Given& given, const std::optional<std::string>& line) {
    if (!line && !given.has("RATIO")) {
        throw InputError("--rod-mass needs RATIO, the mass ratio of the two ends");
    }
    const RatioArgument ratio = parse_ratio_argument(line ? *line : given.text("RATIO"));
    if (ratio.lo != ratio.hi) {
        throw InputError("--rod-mass is for a single mass ratio, not for a range");
    }
    return claim_of(collisions::Rod{ratio.lo, parse_number("--rod-mass", given.text("--rod-mass"))});
}

collisions::Claim given_numbers(const Given& given, const std::optional<std::string>& line) {
    if (!line && !given.has("--inertia")) {
        throw InputError("--rho needs --inertia: the two numbers of a body");
    }
    return collisions::claim_of_body(given.text("--rho"), line ? *line : given.text("--inertia"));
}

}  // namespace

bool is_about_body(const Given& given) {
    return given.has("--coin") || given.has("--rod-mass") || given.has("--rho");
}

collisions::Claim body_claim(const Given& given, const std::optional<std::string>& line) {
    if (!given.has("--rod-mass") && given.has("RATIO")) {
        throw InputError("a body has a RATIO only with --rod-mass; else give --rho and --inertia, or --coin");
    }
    return given.has("--coin")       ? collisions::claim_of_body("1", "4")
           : given.has("--rod-mass") ? rod_of(given, line)
                                     : given_numbers(given, line);
}

}  // namespace dumbbell::cli
