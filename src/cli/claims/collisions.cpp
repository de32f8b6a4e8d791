#include "cli/claims/collisions.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "cli/claims/body.hpp"
#include "collisions/scene.hpp"

namespace dumbbell::cli {

namespace {

collisions::CertifyRequest dumbbell_or_wedge(const Given& given, const RatioArgument& ratio) {
    collisions::CertifyRequest request;
    request.q_lo = ratio.lo;
    request.q_hi = ratio.hi;
    request.scene = *value_named<collisions::Scene>(given.text("--scene"));
    request.section = *value_named<collisions::Section>(given.text("--section"));
    if (row_of(request.scene).charts(request.section).empty()) {
        throw InputError(
            fmt::format("--section {} is for the scene dumbbell: the wedges have --section turning",
                        name(request.section)));
    }
    return request;
}

}  // namespace

collisions::CertifyRequest request_of(const Given& given, const std::optional<RatioArgument>& ratio) {
    if (!ratio && given.has("--section")) {
        throw InputError("bodies are of --scene body, without --section");
    }
    collisions::CertifyRequest request = ratio ? dumbbell_or_wedge(given, *ratio) : body_request(given);
    request.gap = parse_gap(given.text("--gap"));
    if (const auto reason =
            collisions::out_of_reach(request.q_lo, request.q_hi, request.scene, request.section)) {
        throw InputError(*reason);
    }
    if (request.heights && !collisions::fit_a_line(request.heights->lo, request.heights->hi)) {
        throw InputError("the rho of the body is too long for a line of a certificate: write fewer digits");
    }
    return request;
}

}  // namespace dumbbell::cli
