#include "cli/claims/collisions.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "collisions/names.hpp"
#include "number/decimal.hpp"

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
    if (ratio.hi > collisions::greatest_ratio()) {
        throw InputError(
            fmt::format("the mass ratio {} is beyond 10^36, the greatest that is tried: one orbit "
                        "has about 10^18 collisions there",
                        printable(exact_text(ratio.hi), 40)));
    }
    if (ratio.lo != ratio.hi && ratio.hi > parse_rational("1e16")) {
        throw InputError("ranges are tried up to 10^16: beyond, prove one mass ratio at a time");
    }
    collisions::CertifyRequest request;
    request.q_lo = ratio.lo;
    request.q_hi = ratio.hi;
    request.gap = parse_gap(given.text("--gap"));
    request.scene = *collisions::scene_named(given.text("--scene"));
    request.section = section_of(given);
    return request;
}

}  // namespace dumbbell::cli
