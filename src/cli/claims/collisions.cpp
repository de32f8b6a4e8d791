#include "cli/claims/collisions.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "collisions/names.hpp"
#include "number/decimal.hpp"

namespace dumbbell {
namespace {

Section section_of(const CertifyClaim& claim) {
    if (claim.section == "turning") {
        return Section::turning;
    }
    return claim.lemmas == "none" ? Section::plain : Section::full;
}

}  // namespace

CLI::Option* add_claim_options(CLI::App& command, CertifyClaim& claim) {
    CLI::Option* ratio = command.add_option("RATIO", claim.ratio, "mass ratio, or closed range LO:HI");
    command
        .add_option("--scene", claim.scene,
                    "the system: dumbbell, or the source paper's hybrid or straight wedge")
        ->check(CLI::IsMember({"dumbbell", "hybrid", "wedge"}))
        ->capture_default_str();
    command
        .add_option("--section", claim.section,
                    "what is covered: turning, or full (all collision states, forward only)")
        ->check(CLI::IsMember({"turning", "full"}))
        ->capture_default_str();
    command
        .add_option("--lemmas", claim.lemmas,
                    "with --section full: none for plain interval evaluation, without monotonicity")
        ->check(CLI::IsMember({"all", "none"}))
        ->capture_default_str();
    command
        .add_option("--gap", claim.gap,
                    "ranges: relative width of the gap around a critical ratio, at most 0.01")
        ->type_name("REL")
        ->capture_default_str();
    return ratio;
}

CertifyRequest request_of(const CertifyClaim& claim, const RatioArgument& ratio) {
    if (claim.lemmas == "none" && claim.section != "full") {
        throw InputError("--lemmas none needs --section full");
    }
    if (claim.section == "full" && claim.scene != "dumbbell") {
        throw InputError("--section full is for the scene dumbbell: the wedges have --section turning");
    }
    if (ratio.hi > greatest_ratio()) {
        throw InputError(
            fmt::format("the mass ratio {} is beyond 10^16, the greatest that is tried: one orbit "
                        "has about 10^8 collisions there",
                        printable(exact_text(ratio.hi), 40)));
    }
    CertifyRequest request;
    request.q_lo = ratio.lo;
    request.q_hi = ratio.hi;
    request.gap = parse_gap(claim.gap);
    request.scene = *scene_named(claim.scene);
    request.section = section_of(claim);
    return request;
}

}  // namespace dumbbell
