#include "cli/claims/collisions.hpp"

#include "base/error.hpp"
#include "cli/claims/body.hpp"
#include "collisions/section.hpp"

namespace dumbbell::cli {
namespace {

collisions::Claim dumbbell_claim(const Given& given, const RatioArgument& ratio) {
    const auto section = collisions::section_named("dumbbell", given.text("--section"));
    return {.range = {ratio.lo, ratio.hi}, .system = {section.value()}};
}

}  // namespace

collisions::Claim claim_of(const Given& given, const std::optional<std::string>& line) {
    const bool body = is_about_body(given);
    collisions::Claim claim =
        body ? body_claim(given, line)
             : dumbbell_claim(given, parse_ratio_argument(line ? *line : given.text("RATIO")));
    if (body && given.has("--section")) {
        if (given.text("--section") != "plain") {
            throw InputError("bodies are proved by perpendicular orbits, or by --section plain");
        }
        claim = by_plain_covers(std::move(claim));
    }
    claim.gap = parse_gap(given.text("--gap"));
    if (const auto reason = out_of_reach(claim)) {
        throw InputError(*reason);
    }
    return claim;
}

}  // namespace dumbbell::cli
