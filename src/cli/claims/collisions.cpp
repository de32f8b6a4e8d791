#include "cli/claims/collisions.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/names.hpp"

namespace dumbbell::cli {

collisions::CertifyRequest request_of(const Given& given, const RatioArgument& ratio) {
    const std::string section = given.text("--section");
    if (section != "turning" && given.text("--scene") != "dumbbell") {
        throw InputError(fmt::format(
            "--section {} is for the scene dumbbell: the wedges have --section turning", section));
    }
    collisions::CertifyRequest request;
    request.q_lo = ratio.lo;
    request.q_hi = ratio.hi;
    request.gap = parse_gap(given.text("--gap"));
    request.scene = *collisions::scene_named(given.text("--scene"));
    request.section = *collisions::section_named(section);
    if (const auto reason =
            collisions::out_of_reach(request.q_lo, request.q_hi, request.scene, request.section)) {
        throw InputError(*reason);
    }
    return request;
}

}  // namespace dumbbell::cli
