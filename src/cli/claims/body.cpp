#include "cli/claims/body.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/body/given.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"

namespace dumbbell::cli {
namespace {

using collisions::CertifyRequest;

CertifyRequest rod_of(const Given& given) {
    if (!given.has("RATIO")) {
        throw InputError("--rod-mass needs RATIO, the mass ratio of the two ends");
    }
    const RatioArgument ratio = parse_ratio_argument(given.text("RATIO"));
    if (ratio.lo != ratio.hi) {
        throw InputError("--rod-mass is for a single mass ratio, not for a range");
    }
    return collisions::body_of_rod(ratio.lo, parse_number("--rod-mass", given.text("--rod-mass")));
}

CertifyRequest given_numbers(const Given& given) {
    if (!given.has("--rho") || !given.has("--inertia")) {
        throw InputError("--scene body needs --rho and --inertia, or --coin, or --rod-mass with RATIO");
    }
    return collisions::body_of(given.text("--rho"), given.text("--inertia"));
}

}  // namespace

bool is_about_body(const Given& given) {
    return given.has("--coin") || given.has("--rod-mass") || given.has("--rho") ||
           given.text("--scene") == "body";
}

std::string rod_words(const Given& given) {
    if (!given.has("--rod-mass")) {
        return "";
    }
    const Rational mass = parse_number("--rod-mass", given.text("--rod-mass"));
    return fmt::format("--ratio {} --rod-mass {}", exact_text(parse_ratio_argument(given.text("RATIO")).lo),
                       denominator(mass) == 1 ? numerator(mass).str() : to_fraction(mass));
}

CertifyRequest body_request(const Given& given) {
    const auto scene = given.has("--scene") ? given.text("--scene") : "body";
    if (scene != "body") {
        throw InputError("bodies are of --scene body");
    }
    if (!given.has("--rod-mass") && given.has("RATIO")) {
        throw InputError("a body has a RATIO only with --rod-mass; else give --rho and --inertia, or --coin");
    }
    return given.has("--coin")       ? collisions::body_of("1", "4")
           : given.has("--rod-mass") ? rod_of(given)
                                     : given_numbers(given);
}

}  // namespace dumbbell::cli
