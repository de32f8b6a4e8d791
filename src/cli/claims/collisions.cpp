#include "cli/claims/collisions.hpp"

#include "base/error.hpp"
#include "collisions/names.hpp"

namespace dumbbell::cli {
namespace {

collisions::Section section_of(const Given& given) {
    if (given.text("--section") == "turning") {
        return collisions::Section::turning;
    }
    return given.text("--lemmas") == "none" ? collisions::Section::plain : collisions::Section::full;
}

}  // namespace

collisions::CertifyRequest request_of(const Given& given, const RatioArgument& ratio) {
    if (given.text("--lemmas") == "none" && given.text("--section") != "full") {
        throw InputError("--lemmas none needs --section full");
    }
    if (given.text("--section") == "full" && given.text("--scene") != "dumbbell") {
        throw InputError("--section full is for the scene dumbbell: the wedges have --section turning");
    }
    collisions::CertifyRequest request;
    request.q_lo = ratio.lo;
    request.q_hi = ratio.hi;
    request.gap = parse_gap(given.text("--gap"));
    request.scene = *collisions::scene_named(given.text("--scene"));
    request.section = section_of(given);
    if (const auto reason =
            collisions::out_of_reach(request.q_lo, request.q_hi, request.scene, request.section)) {
        throw InputError(*reason);
    }
    return request;
}

}  // namespace dumbbell::cli
